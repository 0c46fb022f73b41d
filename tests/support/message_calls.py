"""Calls that make messages, found in the syntax trees of the program."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from lispac.message_texts import TEXTS
from lispac.messages import Level

ROOT = Path(__file__).resolve().parents[2]
MAKERS = ("error", "warning", "note")
MAX_STEPS = 4
"""Maximum number of names that are followed from a call to a constant."""

NODE_TYPES = (ast.Call, ast.Return, ast.Yield, ast.keyword, ast.ClassDef)
"""Nodes among which calls, returned values and attributes are found."""

Scope = tuple[ast.AST, ...]
"""Functions that contain an expression, the innermost first."""
Source = tuple[ast.expr, Scope]


@cache
def trees() -> dict[Path, ast.Module]:
    """Syntax tree of each module of the program."""
    files = sorted((ROOT / "lispac").rglob("*.py"))
    return {path: ast.parse(path.read_text(encoding="utf-8")) for path in files}


def calls() -> list[tuple[str, ast.Call]]:
    """Every call that makes a message with a literal code, with its place."""
    return [
        (f"{path.name}:{node.lineno}", node)
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id in MAKERS
        and node.args
        and isinstance(node.args[0], ast.Constant)
    ]


@cache
def message_levels() -> dict[str, set[str]]:
    """Levels that the calls of the program can give each code, including codes in variables."""
    levels: dict[str, set[str]] = defaultdict(set)
    for call, scope in (each for found in _calls().values() for each in found):
        makers = _names(call.func)
        for name in makers if scope else ():
            makers = makers.union(*map(_names, _assigned(scope[0]).get(name, ())))
        levels_of_call, texts = {*MAKERS} & makers, call.args[:1]
        if "Message" in makers and len(call.args) > 1:
            levels_of_call = {
                each.lower() for each in _matching(Level.__members__, call.args[1], scope)
            }
        elif not levels_of_call:  # a function with the maker as an argument
            levels_of_call = {*MAKERS} & {
                each.id for each in call.args if isinstance(each, ast.Name)
            }
            texts = [each for each in call.args if isinstance(each, ast.Constant)]
        for text in texts if levels_of_call else ():
            for code in _matching(TEXTS, text, scope):
                levels[code] |= levels_of_call
    return levels


def is_part(code: str) -> bool:
    """Whether the text of a code is not a sentence, so that it occurs only in other messages."""
    text = TEXTS[code]
    words = re.sub(r"\{.*?\}", "x", text if isinstance(text, str) else text.plural)
    return not re.search(r"[.:?]( |$)", words)


@cache
def _literal() -> set[str]:
    """Literal codes of a call."""
    firsts = [call.args[0] for found in _calls().values() for call, _ in found if call.args]
    return {each.value for each in firsts if isinstance(each, ast.Constant)}


def _matching(known: Iterable[str], node: ast.expr, scope: Scope) -> set[str]:
    if isinstance(node, ast.Constant):
        return {node.value} & {*known}
    pattern = re.compile("|".join(_patterns(node, scope, MAX_STEPS, set())) or "(?!)")
    return {each for each in known if pattern.fullmatch(each)}


def _patterns(node: ast.AST, scope: Scope, steps: int, visited: set[ast.AST]) -> set[str]:
    """Regular expressions of the possible texts of an expression; none for one in ``visited``."""
    if node in visited:
        return set()
    visited.add(node)
    if isinstance(node, ast.Constant):
        return {re.escape(node.value)} if isinstance(node.value, str) else set()
    if isinstance(node, ast.JoinedStr):
        parts = [_patterns(each, scope, steps, set(visited)) or {r"\w+"} for each in node.values]
        found = "".join(f"(?:{'|'.join(each)})" for each in parts)
        if not any(re.fullmatch(found, each) for each in TEXTS):
            found = "".join(
                re.escape(each.value) if isinstance(each, ast.Constant) else r"\w+"
                for each in node.values
            )
            return {each for each in TEXTS.keys() - _literal() if re.fullmatch(found, each)} or {
                found
            }
        return {found}
    inside: Iterable[ast.AST] = ast.iter_child_nodes(node)
    sources: list[Source] = []
    if isinstance(node, ast.IfExp):
        inside = (node.body, node.orelse)
    elif isinstance(node, ast.Dict):
        constants = [each for each in map(ast.unparse, node.values) if "'" in each]
        inside = node.values if constants else [each for each in node.keys if each]
    elif isinstance(node, ast.Subscript):
        inside = (node.value,)
    elif isinstance(node, ast.Call):
        sources = _returned().get(_name(node.func), [])
        inside = (*([node.func.value] if isinstance(node.func, ast.Attribute) else []), *node.args)
    elif isinstance(node, ast.Name):
        sources = _sources(node.id, scope)
    elif isinstance(node, ast.Attribute):
        if node.attr in Level.__members__:
            return {node.attr}
        inside, sources = (), _attributes().get(node.attr, []) + _returned().get(node.attr, [])
    found = {text for each in inside for text in _patterns(each, scope, steps, visited)}
    for source in sources if steps else ():
        found |= _patterns(*source, steps - 1, visited)
    return found


def _sources(name: str, scope: Scope) -> list[Source]:
    """Expressions that a name may refer to, in the enclosing functions or else in the program."""
    for k, function in enumerate(scope):
        found = [(each, scope[k:]) for each in _assigned(function).get(name, ())]
        if isinstance(function, ast.FunctionDef):
            found += _arguments(function, name)
        if found:
            return found
    return [(each, ()) for tree in trees().values() for each in _assigned(tree).get(name, ())]


@cache
def _assigned(scope: ast.AST) -> dict[str, list[ast.expr]]:
    """Expressions assigned to each name of a function or, outside of functions, of a module."""
    found: dict[str, list[ast.expr]] = defaultdict(list)
    nodes = ast.walk(scope) if isinstance(scope, ast.FunctionDef) else ast.iter_child_nodes(scope)
    for node in nodes:
        if isinstance(node, ast.Assign):
            targets, value = node.targets, node.value
        elif isinstance(node, ast.AnnAssign | ast.NamedExpr) and node.value:
            targets, value = [node.target], node.value
        elif isinstance(node, ast.For | ast.comprehension):
            targets, value = [node.target], node.iter
        else:
            continue
        for name in (each for target in targets for each in ast.walk(target)):
            if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Store):
                found[name.id].append(value)
    return found


def _arguments(function: ast.FunctionDef, name: str) -> list[Source]:
    """Arguments that calls of a function give for a parameter, and the default of the parameter."""
    names = [each.arg for each in (*function.args.posonlyargs, *function.args.args)]
    place = names.index(name) if name in names else None
    is_method = bool(names) and names[0] in ("self", "cls")
    found: list[Source] = []
    for call, scope in _calls().get(function.name, ()):
        found += [(each.value, scope) for each in call.keywords if each.arg == name]
        if place is not None:
            found += [(each, scope) for each in call.args[place - is_method :][:1]]
    for parameter, default in (
        *zip(reversed(names), reversed(function.args.defaults), strict=False),
        *zip(
            [each.arg for each in function.args.kwonlyargs], function.args.kw_defaults, strict=True
        ),
    ):
        if parameter == name and default is not None:
            found.append((default, ()))
    return found


@cache
def _calls() -> dict[str, list[tuple[ast.Call, Scope]]]:
    """Calls by the name of the called object; calls without a name have an empty one."""
    found: dict[str, list[tuple[ast.Call, Scope]]] = defaultdict(list)
    for node, scope in _nodes_with_scopes():
        if isinstance(node, ast.Call):
            found[_name(node.func)].append((node, scope))
    return found


@cache
def _returned() -> dict[str, list[Source]]:
    """Expressions returned by functions and properties, by their names."""
    found: dict[str, list[Source]] = defaultdict(list)
    for node, scope in _nodes_with_scopes():
        if (
            isinstance(node, ast.Return | ast.Yield)
            and node.value
            and isinstance(scope[0], ast.FunctionDef)
        ):
            found[scope[0].name].append((node.value, scope))
    return found


@cache
def _attributes() -> dict[str, list[Source]]:
    """Expressions assigned to attributes, by keywords of calls and in classes."""
    found: dict[str, list[Source]] = defaultdict(list)
    for node, scope in _nodes_with_scopes():
        if isinstance(node, ast.keyword) and node.arg:
            found[node.arg].append((node.value, scope))
        elif isinstance(node, ast.ClassDef):
            for name, values in _assigned(node).items():
                found[name] += [(each, scope) for each in values]
    return found


@cache
def _nodes_with_scopes() -> list[tuple[ast.AST, Scope]]:
    """Nodes of `NODE_TYPES` in the program, except for the module of the makers, with functions."""
    found: list[tuple[ast.AST, Scope]] = []
    waiting: list[tuple[ast.AST, Scope]] = [
        (tree, ()) for path, tree in trees().items() if path.name != "messages.py"
    ]
    while waiting:
        node, scope = waiting.pop()
        if isinstance(node, NODE_TYPES):
            found.append((node, scope))
        inner = (node, *scope) if isinstance(node, ast.FunctionDef) else scope
        waiting += [(each, inner) for each in ast.iter_child_nodes(node)]
    return found


def _name(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _names(node: ast.AST) -> set[str]:
    return {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
