"""Texts that a module can display, read from its syntax tree."""

import ast
import re
from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path

VALUE_MARK = "7"
"""Placeholder for values that the program inserts into a sentence."""
FOR_PROGRAMMERS = {"ValueError", "AssertionError", "AttributeError", "FileNotFoundError"}
"""Errors that are not shown to users."""
NEVER_SHOWN = FOR_PROGRAMMERS | {"InputError", "ProjectError", "LispacError"}
"""Errors that end a command and are not stored."""
CATALOGUE_CALLS = {"N_", "Plural", "gettext", "gettext_lazy"}
"""Calls whose texts are in the gettext catalogues."""
PROGRESS_CALLS = {"progress", "step"}
"""Calls whose texts are shown beside a progress bar only temporarily."""
_TWO_WORDS = re.compile(r"[^\W\d_]{2,} .*[^\W\d_]{2,}", re.DOTALL)


def displayed_texts(
    path: Path, functions: set[str] | None = None, *, at_once: bool = False
) -> Iterator[tuple[int, str]]:
    """Line and text of each string with at least two words, with `VALUE_MARK` for values.

    Parameters
    ----------
    functions : only texts in these functions
    at_once : include texts that are not stored: errors and texts of a progress bar
    """
    tree = ast.parse(path.read_text(encoding="utf-8"))
    if functions is None:
        yield from _in(tree, at_once)
        return
    found = [n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef) and n.name in functions]
    assert {each.name for each in found} == functions, path
    for each in found:
        yield from _in(each, at_once)


def _in(node: ast.AST, at_once: bool) -> Iterator[tuple[int, str]]:
    if isinstance(node, ast.Raise) and _name(node.exc) in (
        FOR_PROGRAMMERS if at_once else NEVER_SHOWN
    ):
        return
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return  # a docstring
    if isinstance(node, ast.Call) and _name(node) in CATALOGUE_CALLS:
        return
    if isinstance(node, ast.Call) and _name(node) in PROGRESS_CALLS:
        if at_once:
            for argument in (*node.args, *(each.value for each in node.keywords)):
                yield from _beside_a_bar(argument)
        return
    if isinstance(node, ast.Constant | ast.JoinedStr):
        for text in _texts(node):
            if _TWO_WORDS.search(text):
                yield node.lineno, text
        for inner in ast.walk(node):
            if isinstance(inner, ast.FormattedValue):
                yield from _in(inner.value, at_once)
        return
    for child in ast.iter_child_nodes(node):
        yield from _in(child, at_once)


def _beside_a_bar(argument: ast.expr) -> Iterator[tuple[int, str]]:
    """Text of a step of a progress bar, which may be a single word."""
    if isinstance(argument, ast.Constant | ast.JoinedStr):
        for text in _texts(argument):
            if re.search(r"[^\W\d_]{2}", text):
                yield argument.lineno, text
    else:
        yield from _in(argument, at_once=True)


def _name(error: ast.expr | None) -> str:
    called = error.func if isinstance(error, ast.Call) else error
    return called.id if isinstance(called, ast.Name) else ""


def _texts(node: ast.expr) -> Iterator[str]:
    """Possible texts of an expression: one for each combination of its conditions."""
    values = node.values if isinstance(node, ast.JoinedStr) else []
    conditions = {
        ast.unparse(n.test) for v in values for n in ast.walk(v) if isinstance(n, ast.IfExp)
    }
    for outcomes in product((True, False), repeat=len(conditions)):
        yield _text(node, dict(zip(sorted(conditions), outcomes, strict=True)))


def _text(node: ast.expr, outcomes: Mapping[str, bool]) -> str:
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=values):
            return "".join(_text(value, outcomes) for value in values)
        case ast.FormattedValue(value=value):
            return _text(value, outcomes)
        case ast.IfExp(test=test, body=body, orelse=orelse) if ast.unparse(test) in outcomes:
            return _text(body if outcomes[ast.unparse(test)] else orelse, outcomes)
        case _:
            return VALUE_MARK
