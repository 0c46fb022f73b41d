"""Rules for messages, read from the syntax trees: errors have codes, and no code reads words."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from lispac import errors

ROOT = Path(__file__).resolve().parents[1] / "lispac"
MODULES = sorted(ROOT.rglob("*.py"))
TYPED = {
    name for name, kind in vars(errors).items()
    if isinstance(kind, type) and issubclass(kind, errors.LispacError)
}  # fmt: skip
TEXT_METHODS = {"startswith", "endswith", "find", "index"}
"""Methods of text by which code would look at the words of an error."""

WITHOUT_CODE = {
    "reverse_translation/catalogue.py": 1,
}
"""Errors with a text alone, by module: they are to become messages, and no new ones come."""


def raised_with_text(tree: ast.AST) -> Iterator[int]:
    """Lines that raise an error of the program with a text."""
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.Raise)
            and isinstance(node.exc, ast.Call)
            and isinstance(node.exc.func, ast.Name)
            and node.exc.func.id in TYPED
            and node.exc.args
            and isinstance(node.exc.args[0], ast.Constant | ast.JoinedStr)
        ):
            yield node.lineno


def words_read(tree: ast.AST) -> Iterator[int]:
    """Lines that test the text of an error that was caught."""
    for handler in ast.walk(tree):
        if not isinstance(handler, ast.ExceptHandler) or handler.name is None:
            continue
        for node in ast.walk(handler):
            if isinstance(node, ast.Compare):
                tested: list[ast.expr] = [node.left, *node.comparators]
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
                tested = [node.func.value] if node.func.attr in TEXT_METHODS else []
            else:
                continue
            if any(is_text_of(each, handler.name) for each in tested):
                yield node.lineno


def is_text_of(node: ast.expr, name: str) -> bool:
    """Whether an expression is ``str(name)``."""
    return (
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "str"
        and [ast.unparse(each) for each in node.args] == [name]
    )


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_errors_have_codes_and_no_code_reads_their_words(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    known = WITHOUT_CODE.get(path.relative_to(ROOT).as_posix(), 0)
    assert len(list(raised_with_text(tree))) == known
    assert list(words_read(tree)) == []


def test_the_rules_find_what_they_forbid() -> None:
    source = (
        "try:\n    raise InputError(f'{a}: no')\n"
        "except InputError as e:\n    b = 'no' in str(e) or str(e).startswith('x')\n"
    )
    tree = ast.parse(source)
    assert list(raised_with_text(tree)) == [2]
    assert list(words_read(tree)) == [4, 4]
