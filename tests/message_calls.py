"""Where the program makes its messages, read from the syntax trees of its modules."""

import ast
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MAKERS = ("error", "warning", "note")


def calls() -> list[tuple[str, ast.Call]]:
    """Every call that makes a message with a code of its own, with its place."""
    found = []
    for path in (ROOT / "lispac").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if (
                isinstance(node, ast.Call)
                and isinstance(node.func, ast.Name)
                and node.func.id in MAKERS
                and node.args
                and isinstance(node.args[0], ast.Constant)
            ):
                found.append((f"{path.name}:{node.lineno}", node))
    return found
