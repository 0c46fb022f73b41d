"""Tests that docstrings of the core give shapes of arrays, units, frames and sources.

The syntax trees are searched for attributes of public dataclasses, and for parameters and results
of public functions and methods. Arrays are recognised by their annotations. A quantity is a
number or an array whose name says that it is a length, an angle, a time or a sigma (`QUANTITY`).
A name that ends in its unit (``error_deg``, ``rms_m``) needs no more. Coordinates are arrays of
three columns, or three numbers, in metres or with the name of a place or direction (`PLACE`); a
name that ends in its frame (``points_lidar``) needs no more. Ruff checks that raised errors are
documented; these tests check that documented errors exist.

A parameter is described in its entry, or in the text of the docstring, which then has to mention
its name or the first word of it. A docstring may refer to another one ("As `local_planes_kernel`"),
which has to exist.
"""

import ast
import builtins
import re
from collections.abc import Iterator
from functools import cache
from itertools import chain
from pathlib import Path

import pytest

from tests.support.public_names import CORE, Documented, Name, modules, public, trees

QUANTITY = re.compile(
    r"(^|_)(sigmas?|radius|distances?|height|width|angles?|times?|duration|thickness|spacing|"
    r"lever_arm|boresight|roll|pitch|yaw|heading|misclosures?|position|rms|speed|latitude|"
    r"longitude|rate)(_|$)"
)
SUFFIXED = re.compile(r"_(deg|m|mm|s|m_s|ms|hz|ppm|metres|seconds)$")
UNIT = re.compile(
    r"\b(metres?|mm|millimetres?|deg|degrees?|radians?|seconds?|minutes|hours|days|pixels|hertz|"
    r"inches|share|(no|a|same|its|own|their|that) units?|unit of|unit and axes)\b",
    re.IGNORECASE,
)
SHAPE = re.compile(r"\([^()]*,[^()]*\)|\(\.\.\.\)|(of|in) (that|the same|any) shape")
"""As ``(n, 3)``, ``(n,)`` and ``(..., 3)``."""
PLACE = re.compile(
    r"(^|_)(points?|xyz|centres?|normals?|positions?|origins?|places?|seed|beams?|vertices|corners?|"
    r"lever_arms?|middles?|velocity|velocities|coordinates|scanner|through|towards|translation)(_|$)"
)
THREE = re.compile(r"\((?!3, 3\))(?:[^()]*, )?3,?\)")
LENGTH = re.compile(r"\b(metres|unit (vector|normal)s?)\b")
NO_PLACE = re.compile(r"no unit|square metres|metres per radian|[Mm]etres in|tilts", re.I)
"""Words for three numbers that are not the coordinates of one place."""
FRAMED = re.compile(r"_(lidar|body|local)$")
FRAME = re.compile(
    r"\b(frame|local|LiDAR|body|earth-centred|map|north|axes of|coordinate system)\b",
    re.IGNORECASE,
)
SOURCE = re.compile(
    r"[Tt]hesis|[A-Z][\w-]+,? \(?(1[89]|20)\d\d\b|et al\. \(?\d{4}|'s [\w ]+\(\d{4}\)|"
    r"\b(Golub and Van Loan|Hofmann-Wellenhof|CloudCompare|Bonferroni|PROJ|S-44|Equation \d)"
)
"""As "thesis equation 4.3" and "Baarda 1968"."""
MATHEMATICS = re.compile(
    r"np\.linalg\.(?!norm)|np\.(sin|cos|tan|arcsin|arccos|exp|log|cov|einsum)\b|@njit|"
    r"scipy\.(linalg|optimize|special|stats)"
)
REFERENCE = re.compile(
    r"\b(?:[Ss]ee|[Aa]s(?: for| in| of)?|[Ll]ike|inverse of|those of) `([\w.]+)`"
)
"""References to another docstring."""


@cache
def arrays(module: str) -> re.Pattern[str]:
    """Pattern of the array annotations in a module: those of NumPy and aliases of the module."""
    names = {"NDArray", "ndarray"}
    for node in trees()[module].body:
        if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("NDArray"):
            names |= {ast.unparse(target) for target in node.targets}
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("lispac."):
            path = f"{str(node.module).replace('.', '/')}.py"
            if path in trees():
                own = arrays(path)
                names |= {alias.name for alias in node.names if own.fullmatch(alias.name)}
    return re.compile(rf"(np\.)?({'|'.join(sorted(names))})\b")


def kinds(annotation: ast.expr | None) -> list[str]:
    """Alternatives of an annotation: ``float | Array`` has two."""
    words = "" if annotation is None else ast.unparse(annotation).strip("'\"")
    return [kind.strip() for kind in words.split("|")]


def is_array(module: str, annotation: ast.expr | None) -> bool:
    """Whether the annotation allows an array."""
    return any(arrays(module).match(kind) for kind in kinds(annotation))


def is_quantity(module: str, name: str, annotation: ast.expr | None) -> bool:
    """Whether a value is a number with a unit, by its name."""
    number = is_array(module, annotation) or "float" in kinds(annotation)
    return bool(number and QUANTITY.search(name) and not SUFFIXED.search(name))


def is_place(module: str, name: str, annotation: ast.expr | None, description: str) -> bool:
    """Whether a value is coordinates or a direction whose name does not give the frame."""
    triples = {"Triple", "tuple[float, float, float]"}
    array = is_array(module, annotation)
    if not (array or triples & set(kinds(annotation))) or "sigma" in name or FRAMED.search(name):
        return False
    if NO_PLACE.search(description) or (
        array and SHAPE.search(description) and not THREE.search(description)
    ):
        return False
    if "radians" in description and not LENGTH.search(description):
        return False
    return bool(PLACE.search(name) or (THREE.search(description) and LENGTH.search(description)))


def fields(node: ast.ClassDef) -> dict[str, ast.expr]:
    """Public attributes of a dataclass and their annotations; empty for other classes."""
    if not any("dataclass" in ast.unparse(decorator) for decorator in node.decorator_list):
        return {}
    return {
        item.target.id: item.annotation
        for item in node.body
        if isinstance(item, ast.AnnAssign)
        and isinstance(item.target, ast.Name)
        and item.target.id[0] != "_"
    }


def parameters(node: ast.FunctionDef) -> dict[str, ast.expr | None]:
    """Parameters and their annotations."""
    arguments = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
    return {each.arg: each.annotation for each in arguments if each.arg not in ("self", "cls")}


def missing_descriptions(found: Name) -> Iterator[str]:
    """Shapes, units and frames that are missing in the docstring of a name."""
    of_class = isinstance(found.node, ast.ClassDef)
    entries = found.docstring.entries("Attributes" if of_class else "Parameters")
    words, module = found.docstring.words, found.module
    values = fields(found.node) if of_class else parameters(found.node)
    for name, annotation in values.items():
        named = re.search(rf"\b({name}|{name.split('_')[0]})s?\b", words, re.IGNORECASE)
        description = entries.get(name, words if named else "")
        if REFERENCE.search(description or words):
            continue
        if is_array(module, annotation) and not SHAPE.search(description):
            yield f"{found.where}: shape of {name}"
        if is_quantity(module, name, annotation) and not UNIT.search(description):
            yield f"{found.where}: unit of {name}"
        if is_place(module, name, annotation, description) and not FRAME.search(description):
            yield f"{found.where}: frame of {name}"
    if of_class:
        return
    result = found.node.returns
    description = f"{found.docstring.sections.get('Returns')}\n{words}"
    if REFERENCE.search(description):
        return
    if is_array(module, result) and not SHAPE.search(description):
        yield f"{found.where}: shape of what it returns"
    if is_quantity(module, found.node.name, result) and not UNIT.search(description):
        yield f"{found.where}: unit of what it returns"
    description = found.docstring.sections.get("Returns", words)
    if is_place(module, found.node.name, result, description) and not FRAME.search(description):
        yield f"{found.where}: frame of what it returns"


PACKAGES = sorted({path.relative_to(CORE).parts[0] for path in modules()} - {"__init__.py"})


@cache
def names() -> set[str]:
    """All names that a docstring can refer to, including builtin ones."""
    found = {Path(module).stem for module in trees()} | set(dir(builtins))
    for node in chain.from_iterable(map(ast.walk, trees().values())):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
        elif isinstance(node, ast.Attribute):
            found.add(node.attr)
    return found


def test_docstrings_refer_to_existing_names() -> None:
    references = [
        (name.where, to)
        for package in PACKAGES
        for name in public(package)
        for to in REFERENCE.findall(ast.get_docstring(name.node) or "")
    ]
    assert len(references) > 50
    assert [each for each in references if each[1].rpartition(".")[2] not in names()] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_shapes_units_and_frames_are_documented(package: str) -> None:
    assert [words for name in public(package) for words in missing_descriptions(name)] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_errors_in_raises_sections_exist(package: str) -> None:
    raised = {
        (name.where, error)
        for name in public(package)
        for error in name.docstring.entries("Raises")
    }
    assert {each for each in raised if each[1].rpartition(".")[2] not in names()} == set()


WITHOUT_SOURCE = {
    "adjustment": {
        "iteration",
        "observability",
        "adjustment_problem",
        "solved_equations",
        "sphere_radii",
        "solution",
        "determinability",
    },
    "design": {"further_line_advice", "monte_carlo", "prediction", "site"},
    "geometry": {"radius_search"},
    "simulation": {"ray_casting", "pos_error_models", "scene", "vessel_motion"},
    "survey": {
        "axes",
        "correction",
        "mounting_replacement",
        "scanner_frame_recovery",
        "scanner_frame_recovery_check",
        "row_runs",
        "scan",
        "mounting_texts",
    },
    "targets": {
        "planes_across_lines",
        "outline",
        "sighting_quality",
        "cross_section",
        "cloud_shift",
        "boresight_smear",
    },
    "validation": {
        "absolute_check",
        "line_overlap",
        "surface_layers",
        "cylinder_diameters",
        "plane_offset",
    },
}
"""Modules that compute without naming a source: their methods are original and described in their
docstrings, or common knowledge (a rotation about an axis, a mean with its sigma)."""


@pytest.mark.parametrize("package", WITHOUT_SOURCE)
def test_modules_that_compute_name_their_sources(package: str) -> None:
    without = set()
    documented = (ast.Module, ast.FunctionDef, ast.ClassDef)
    for module, tree in trees().items():
        if module.split("/")[1] != package:
            continue
        docstrings = [
            ast.get_docstring(x) or "" for x in ast.walk(tree) if isinstance(x, documented)
        ]
        source = (CORE.parent / module).read_text(encoding="utf-8")
        if MATHEMATICS.search(source) and not SOURCE.search("\n".join(docstrings)):
            without.add(Path(module).stem)
    assert without == WITHOUT_SOURCE[package]


COMPLETE_EXAMPLE = '''
def turned(points: Array, angle: float, sigma_deg: float) -> Array:
    """Points turned by an angle, radians.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, body frame

    Returns
    -------
    ndarray of shape (m, 3), metres, local frame
    """
'''


@pytest.mark.parametrize(
    ("removed", "found"),
    [
        ("", []),
        (", radians", ["unit of angle"]),
        (" of shape (m, 3)", ["shape of what it returns"]),
        (", body frame", ["frame of points"]),
        (", local frame", ["frame of what it returns"]),
        (" of shape (n, 3)", ["shape of points"]),
        ("_deg", ["unit of sigma"]),
    ],
)
def test_missing_descriptions_are_found(removed: str, found: list[str]) -> None:
    (node,) = ast.parse(COMPLETE_EXAMPLE.replace(removed, "", 1)).body
    assert isinstance(node, ast.FunctionDef)
    docstring = Documented.of(ast.get_docstring(node) or "")
    name = Name("lispac/geometry/planes.py", node.name, node, docstring)
    assert [words.partition(": ")[2] for words in missing_descriptions(name)] == found
