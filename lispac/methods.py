"""Answers of several methods side by side (the program's own table 4.4 of the thesis)."""

from collections.abc import Mapping
from dataclasses import dataclass

from lispac.adjustment.message_parts import quantities
from lispac.adjustment.result import ANGLES
from lispac.messages import Message, note
from lispac.opinions import METHODS, Method
from lispac.project import Project
from lispac.validation.repeatability import Calibration, Difference, difference

TARGETS = "targets"
FAR = 50.0
"""Distances, metres, at which the effect of a difference on a point is given."""

NAMES: Mapping[str, str] = {
    TARGETS: "method.targets",
    "natural planes": "method.natural_planes",
    "targetless": "method.targetless",
    "patch test": "method.patch_test",
}
"""Code of each method's name as part of a message."""


@dataclass(frozen=True, eq=False)
class MethodResult:
    """Result of one method.

    Attributes
    ----------
    calibration : Calibration
        Named after its method.
    lines, surfaces : int
        That the answer rests on.
    against : Difference or None
        From the first answer to this one; None for the first.
    remarks : tuple of Message
    """

    calibration: Calibration
    lines: int
    surfaces: int
    against: Difference | None
    remarks: tuple[Message, ...]

    @property
    def method(self) -> str:
        """Its name."""
        return self.calibration.name


def answers(project: Project) -> tuple[MethodResult, ...]:
    """Available results, that of the targets first; each is compared with the first."""
    found: list[MethodResult] = []

    def add(said: Calibration, lines: int, surfaces: int, remarks: tuple[Message, ...]) -> None:
        against = difference(found[0].calibration, said) if found else None
        found.append(MethodResult(said, lines, surfaces, against, remarks))

    result = project.result
    if result is not None:
        seen = [each.sighting for each in result.sightings]
        add(
            Calibration(TARGETS, result.boresight, result.covariance),
            len({each.line for each in seen}), len({each.target for each in seen}), (),
        )  # fmt: skip
    for each in project.opinions:
        add(
            Calibration(each.method, each.boresight, each.covariance),
            len(each.lines), each.surfaces, each.remarks,
        )  # fmt: skip
    return tuple(found)


def missing(project: Project) -> tuple[Method, ...]:
    """Methods without a result."""
    return tuple(method for method in METHODS if project.opinion(method) is None)


def remarks_on(found: tuple[MethodResult, ...]) -> tuple[Message, ...]:
    """Whether the methods agree, one remark for each but the first, and what limits this."""
    if len(found) < 2:
        return ()
    compared = [_comparison(each.against) for each in found if each.against is not None]
    return (*compared, note("methods.same_lines"))


def _comparison(against: Difference) -> Message:
    angles = [name for name, yes in zip(ANGLES, against.significant, strict=True) if yes]
    code = "methods.differ" if angles else "methods.differ_together"
    return note(
        code if against.differ else "methods.agree",
        method=note(NAMES[against.second]), other=note(NAMES[against.first]),
        angles=quantities(angles), distance=FAR, displacement=against.displacement(FAR),
    )  # fmt: skip
