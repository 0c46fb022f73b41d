"""Resolve names of docstrings and signatures in the API reference."""

import ast
from collections.abc import Iterator
from functools import cache

import lispac
from tests.support.public_names import trees

FOREIGN = (
    "NDArray", "abc", "argparse", "collections", "concurrent", "contextlib", "datetime", "enum",
    "distributed", "functools", "jinja2", "laspy", "lazrs", "matplotlib", "np", "numba", "numpy",
    "open3d", "pathlib", "pye57", "pyproj", "scipy", "threading", "types", "typing", "typst",
    "ArgumentTypeError", "CRS", "Commands", "LinAlgError", "cKDTree",
)  # fmt: skip
"""Packages and single names that the reference does not link."""


def script_names() -> dict[str, str]:
    """Names exported by ``import lispac``: the full name in its module, and the public name."""
    return {f"{module}.{name}": f"lispac.{name}" for name, module in lispac._MODULE_OF_NAME.items()}


def documented_as(name: str) -> str:
    """Name of an object in the reference: the public name if ``lispac`` exports it."""
    for full, short in script_names().items():
        if name == full or name.startswith(f"{full}."):
            return short + name.removeprefix(full)
    return name


@cache
def known() -> set[str]:
    """Names defined in modules and classes, including constants without a docstring."""
    found = set()
    for module, tree in trees().items():
        dotted = module.removesuffix(".py").replace("/", ".").removesuffix(".__init__")
        found |= {dotted, *_stored(dotted, tree.body)}
    return found


def _stored(above: str, nodes: list[ast.stmt]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield f"{above}.{node.name}"
        if isinstance(node, ast.ClassDef):
            yield from _stored(f"{above}.{node.name}", node.body)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = (name for target in targets for name in ast.walk(target))
            yield from (f"{above}.{name.id}" for name in names if isinstance(name, ast.Name))


def is_there(name: str) -> bool:
    """Whether a name exists in the code, though it is not in the reference."""
    return name in known() or any(each.endswith(f".{name}") for each in known())
