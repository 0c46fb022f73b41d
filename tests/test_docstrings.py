"""Docstrings of the core say every array's shape, quantity's unit, place's frame, formula's source.

Read from the syntax trees. What is looked at: attributes of public dataclasses, parameters and
results of public functions and methods. An array is what is annotated as one. A quantity is a
number or an array whose name says that it is a length, an angle, a time or a sigma (`QUANTITY`).
A name that ends in its unit (``error_deg``, ``rms_m``) needs no more. Coordinates are arrays of
three columns, or three numbers, in metres or with the name of a place or direction (`PLACE`); a
name that ends in its frame (``points_lidar``) needs no more. What errors a function raises is
ruff's affair; here it is looked whether there are such errors.

What is said of a parameter stands in the entry of its name, or in the words of the docstring, which
then have to name it, whole or by its first word. A docstring may send to another one ("As
`local_planes_kernel`"), which has to be there.
"""

import ast
import builtins
import re
from collections.abc import Iterator
from functools import cache
from itertools import chain
from pathlib import Path

import pytest

from tests.public_names import CORE, Documented, Name, modules, public, trees

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
"""Three numbers, but none of the coordinates of one place."""
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
ELSEWHERE = re.compile(
    r"\b(?:[Ss]ee|[Aa]s(?: for| in| of)?|[Ll]ike|inverse of|those of) `([\w.]+)`"
)
"""Words that send to another docstring."""


@cache
def arrays(module: str) -> re.Pattern[str]:
    """Annotations of arrays in a module: NumPy's, and what it calls them, by itself or imported."""
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
    """What an annotation admits: ``float | Array`` is two."""
    words = "" if annotation is None else ast.unparse(annotation).strip("'\"")
    return [kind.strip() for kind in words.split("|")]


def is_array(module: str, annotation: ast.expr | None) -> bool:
    """Whether it may be an array."""
    return any(arrays(module).match(kind) for kind in kinds(annotation))


def is_quantity(module: str, name: str, annotation: ast.expr | None) -> bool:
    """Whether it is a number with a unit, by its name."""
    number = is_array(module, annotation) or "float" in kinds(annotation)
    return bool(number and QUANTITY.search(name) and not SUFFIXED.search(name))


def is_place(module: str, name: str, annotation: ast.expr | None, said: str) -> bool:
    """Whether it is coordinates or a direction, in a frame that its name does not say."""
    triples = {"Triple", "tuple[float, float, float]"}
    array = is_array(module, annotation)
    if not (array or triples & set(kinds(annotation))) or "sigma" in name or FRAMED.search(name):
        return False
    if NO_PLACE.search(said) or (array and SHAPE.search(said) and not THREE.search(said)):
        return False
    if "radians" in said and not LENGTH.search(said):
        return False
    return bool(PLACE.search(name) or (THREE.search(said) and LENGTH.search(said)))


def fields(node: ast.ClassDef) -> dict[str, ast.expr]:
    """Public attributes of a dataclass and their annotations; none of other classes."""
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
    given = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
    return {each.arg: each.annotation for each in given if each.arg not in ("self", "cls")}


def lacks(found: Name) -> Iterator[str]:
    """What the docstring of a name does not say."""
    of_class = isinstance(found.node, ast.ClassDef)
    entries = found.docstring.entries("Attributes" if of_class else "Parameters")
    words, module = found.docstring.words, found.module
    values = fields(found.node) if of_class else parameters(found.node)
    for name, annotation in values.items():
        named = re.search(rf"\b({name}|{name.split('_')[0]})s?\b", words, re.IGNORECASE)
        said = entries.get(name, words if named else "")
        if ELSEWHERE.search(said or words):
            continue
        if is_array(module, annotation) and not SHAPE.search(said):
            yield f"{found.where}: shape of {name}"
        if is_quantity(module, name, annotation) and not UNIT.search(said):
            yield f"{found.where}: unit of {name}"
        if is_place(module, name, annotation, said) and not FRAME.search(said):
            yield f"{found.where}: frame of {name}"
    if of_class:
        return
    result = found.node.returns
    said = f"{found.docstring.sections.get('Returns')}\n{words}"
    if ELSEWHERE.search(said):
        return
    if is_array(module, result) and not SHAPE.search(said):
        yield f"{found.where}: shape of what it returns"
    if is_quantity(module, found.node.name, result) and not UNIT.search(said):
        yield f"{found.where}: unit of what it returns"
    said = found.docstring.sections.get("Returns", words)
    if is_place(module, found.node.name, result, said) and not FRAME.search(said):
        yield f"{found.where}: frame of what it returns"


PACKAGES = sorted({path.relative_to(CORE).parts[0] for path in modules()} - {"__init__.py"})


@cache
def names() -> set[str]:
    """All names that a docstring can send to, the builtin ones with them."""
    found = {Path(module).stem for module in trees()} | set(dir(builtins))
    for node in chain.from_iterable(map(ast.walk, trees().values())):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
        elif isinstance(node, ast.Attribute):
            found.add(node.attr)
    return found


def test_docstrings_send_to_what_is_there() -> None:
    sent = [
        (name.where, to)
        for package in PACKAGES
        for name in public(package)
        for to in ELSEWHERE.findall(ast.get_docstring(name.node) or "")
    ]
    assert len(sent) > 50
    assert [each for each in sent if each[1].rpartition(".")[2] not in names()] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_shapes_units_and_frames_are_documented(package: str) -> None:
    assert [words for name in public(package) for words in lacks(name)] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_errors_in_raises_sections_exist(package: str) -> None:
    said = {
        (name.where, error)
        for name in public(package)
        for error in name.docstring.entries("Raises")
    }
    assert {each for each in said if each[1].rpartition(".")[2] not in names()} == set()


OWN = {
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
"""Modules that compute and name no source: what they do is nobody else's, and told in their words,
or anybody's (a rotation about an axis, a mean with its sigma)."""


@pytest.mark.parametrize("package", OWN)
def test_modules_that_compute_name_their_sources(package: str) -> None:
    without = set()
    for module, tree in trees().items():
        documented = (ast.Module, ast.FunctionDef, ast.ClassDef)
        said = [ast.get_docstring(x) or "" for x in ast.walk(tree) if isinstance(x, documented)]
        source = (CORE.parent / module).read_text(encoding="utf-8")
        own = module.split("/")[1] == package and MATHEMATICS.search(source)
        if own and not SOURCE.search("\n".join(said)):
            without.add(Path(module).stem)
    assert without == OWN[package]


SAID = '''
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
    ("left_out", "found"),
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
def test_what_is_not_documented_is_found(left_out: str, found: list[str]) -> None:
    (node,) = ast.parse(SAID.replace(left_out, "", 1)).body
    assert isinstance(node, ast.FunctionDef)
    said = Documented.of(ast.get_docstring(node) or "")
    name = Name("lispac/geometry/planes.py", node.name, node, said)
    assert [words.partition(": ")[2] for words in lacks(name)] == found
