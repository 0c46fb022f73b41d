"""Public names of the core and their docstrings, read from the syntax trees."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

CORE = Path(__file__).resolve().parents[2] / "lispac"
HEADING = re.compile(r"^(\w[\w ]*)\n-{3,}$", re.MULTILINE)


@dataclass(frozen=True)
class Documented:
    """A docstring, divided into its sections."""

    words: str
    sections: dict[str, str]

    @classmethod
    def of(cls, docstring: str) -> "Documented":
        """Divide a docstring at its headings; the text before the first heading are its words."""
        words, *rest = HEADING.split(docstring)
        return cls(words, dict(zip(rest[::2], rest[1::2], strict=True)))

    def entries(self, section: str) -> dict[str, str]:
        """Type line and words of each name of a section."""
        found: dict[str, str] = {}
        names: list[str] = []
        for line in self.sections.get(section, "").splitlines():
            if line and not line[0].isspace():
                head, _, kind = line.partition(" : ")
                names = [name.strip().lstrip("*") for name in head.split(",")]
                found |= dict.fromkeys(names, kind)
            else:
                found |= {name: f"{found[name]} {line.strip()}" for name in names}
        return found


@dataclass(frozen=True)
class Name:
    """A function, method or class of the core and its module."""

    module: str
    name: str
    node: ast.FunctionDef | ast.ClassDef
    docstring: Documented

    @property
    def where(self) -> str:
        """Location for the message of a failed test."""
        return f"{self.module}:{self.node.lineno} {self.name}"


def modules() -> list[Path]:
    """Modules of the core."""
    return [path for path in sorted(CORE.rglob("*.py")) if "gui" not in path.parts]


@cache
def trees() -> dict[str, ast.Module]:
    """Syntax trees of the modules of the core."""
    return {
        str(path.relative_to(CORE.parent)): ast.parse(path.read_text(encoding="utf-8"))
        for path in modules()
    }


def public(package: str) -> Iterator[Name]:
    """Public names of a package, including methods and properties."""

    def below(module: str, parent: str, nodes: list[ast.stmt]) -> Iterator[Name]:
        for node in nodes:
            if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name[0] != "_":
                name = f"{parent}{node.name}"
                docstring = Documented.of(ast.get_docstring(node) or "")
                yield Name(module, name, node, docstring)
                if isinstance(node, ast.ClassDef):
                    yield from below(module, f"{name}.", node.body)

    for module, tree in trees().items():
        if module.split("/")[1] == package:
            yield from below(module, "", tree.body)
