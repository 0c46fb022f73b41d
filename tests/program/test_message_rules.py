"""Tests by syntax trees: errors have codes, and no code tests the text of a message."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from lispac import errors

ROOT = Path(__file__).resolve().parents[2] / "lispac"
MODULES = sorted(ROOT.rglob("*.py"))
ERROR_CLASSES = {
    name for name, kind in vars(errors).items()
    if isinstance(kind, type) and issubclass(kind, errors.LispacError)
}  # fmt: skip
TEXT_METHODS = {
    "startswith", "endswith", "find", "rfind", "index", "rindex", "count", "partition",
    "rpartition", "removeprefix", "removesuffix",
}  # fmt: skip
"""Methods of text that test or search its words."""
SEARCH_FUNCTIONS = {"search", "match", "fullmatch", "findall", "finditer"}
"""Functions of ``re`` that search a text."""
TEXT_FUNCTIONS = {"message_text", "english_text"}
TRANSLATION_FUNCTIONS = {"gettext", "ngettext", "N_", "format_text", *TEXT_FUNCTIONS}


def raised_with_text(tree: ast.Module) -> Iterator[int]:
    """Yield the lines that raise an error of the program with a text."""
    texts = {
        target.id
        for node in tree.body
        if isinstance(node, ast.Assign) and is_text(node.value, set())
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.Raise)
            and isinstance(node.exc, ast.Call)
            and isinstance(node.exc.func, ast.Name)
            and node.exc.func.id in ERROR_CLASSES
            and node.exc.args
            and is_text(node.exc.args[0], texts)
        ):
            yield node.lineno


def is_text(node: ast.expr, texts: set[str]) -> bool:
    """Whether an expression is a text: literal, translated or a constant of the module."""
    if isinstance(node, ast.Name):
        return node.id in texts
    if isinstance(node, ast.Call):
        return is_call_of(node, TRANSLATION_FUNCTIONS)
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def words_read(tree: ast.Module) -> Iterator[int]:
    """Yield the lines that test the text of a message or of a caught error."""
    scopes = [each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)]
    nested = {each for scope in scopes for each in ast.walk(scope)}
    outside = [each for each in ast.walk(tree) if each not in nested]
    lines = {
        line for nodes in (outside, *map(list, map(ast.walk, scopes))) for line in _read(nodes)
    }
    yield from sorted(lines)


def _read(nodes: list[ast.AST]) -> Iterator[int]:
    errors_caught = {
        each.name for each in nodes if isinstance(each, ast.ExceptHandler) and each.name
    }
    names: set[str] = set()
    for node in nodes:
        if isinstance(node, ast.Assign | ast.NamedExpr) and is_message_text(
            node.value, errors_caught, names
        ):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names |= {each.id for each in targets if isinstance(each, ast.Name)}
    for node in nodes:
        tested: list[ast.expr] = []
        if isinstance(node, ast.Compare):
            tested = [node.left, *node.comparators]
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            is_re = isinstance(node.func.value, ast.Name) and node.func.value.id == "re"
            if node.func.attr in SEARCH_FUNCTIONS:  # also methods of a compiled expression
                tested = node.args
            if node.func.attr in TEXT_METHODS and not is_re:
                tested = [*tested, node.func.value]
        if any(is_message_text(each, errors_caught, names) for each in tested):
            yield node.lineno  # type: ignore[attr-defined]


def is_message_text(node: ast.expr, errors_caught: set[str], names: set[str]) -> bool:
    """Whether an expression is the text of a message, in any case, or a variable of one."""
    if isinstance(node, ast.Name):
        return node.id in names
    if not isinstance(node, ast.Call):
        return False
    if isinstance(node.func, ast.Attribute) and node.func.attr in ("lower", "upper", "casefold"):
        return is_message_text(node.func.value, errors_caught, names)
    is_error = [ast.unparse(each) in errors_caught for each in node.args] == [True]
    return is_call_of(node, TEXT_FUNCTIONS) or (is_error and is_call_of(node, {"str"}))


def is_call_of(node: ast.Call, functions: set[str]) -> bool:
    """Whether a call calls one of the functions with these names."""
    return getattr(node.func, "id", getattr(node.func, "attr", "")) in functions


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_errors_have_codes_and_no_code_tests_their_texts(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert list(raised_with_text(tree)) == []
    assert list(words_read(tree)) == []


@pytest.mark.parametrize(
    "probe",
    [
        "b = 'x' in message_text(m)", "b = texts.english_text(m) == 'x'",
        "t = message_text(m)\nb = 'x' in t", "b = message_text(m).startswith('x')",
        "b = re.search('x', message_text(m))", "b = PATTERN.search(message_text(m))",
        "b = message_text(m).lower().find('x')", "def f(m):\n    t = message_text(m)\n    'x' in t",
        *(
            f"try:\n    pass\nexcept InputError as e:\n    {read}"
            for read in (
                "b = 'x' in str(e)", "t = str(e)\n    b = 'x' in t", "b = str(e).startswith('x')",
                "b = re.search('x', str(e))", "b = 'x' in (t := str(e)) or 'y' in t",
            )
        ),
    ],
)  # fmt: skip
def test_a_test_of_the_text_of_a_message_is_found(probe: str) -> None:
    assert len(list(words_read(ast.parse(probe)))) == 1


@pytest.mark.parametrize(
    "probe",
    [
        "raise InputError('x')", "raise InputError(f'{a}: x')", "raise InputError(gettext('x'))",
        "TEXT = 'x'\nraise InputError(TEXT)", "TEXT = N_('x')\nraise InputError(TEXT)",
        "raise InputError(message_text(m))",
    ],
)  # fmt: skip
def test_an_error_with_a_text_is_found(probe: str) -> None:
    assert len(list(raised_with_text(ast.parse(probe)))) == 1


def test_showing_a_text_is_allowed() -> None:
    source = (
        "try:\n    raise InputError(error('a.b'))\nexcept InputError as e:\n    print(str(e))\n"
        "label.setText(message_text(m))\nb = e.code == 'a.b'\n"
    )
    tree = ast.parse(source)
    assert [*raised_with_text(tree), *words_read(tree)] == []
