"""Answers of several methods side by side (the program's own table 4.4 of the thesis)."""

from dataclasses import dataclass

from lispac.adjustment.result import ANGLES
from lispac.adjustment.shown import listed
from lispac.opinions import METHODS, Method
from lispac.project import Project
from lispac.validation.repeatability import Calibration, Difference, difference

TARGETS = "targets"
FAR = 50.0
"""Metres at which it is said what a difference does to a point."""

SHARED = (
    "All methods rest on the same lines. What an error of the trajectory does to all of them alike "
    "no comparison shows, and as they share it, their difference is judged by more than its own "
    "sigma: where they differ, something is wrong; that they agree is no proof."
)

WANTED: dict[Method, str] = {
    "natural planes": "the same adjustment on the validation planes instead of the targets",
    "targetless": "surfaces of the scene that no one picked",
    "patch test": "lines turned until they meet on objects",
}
"""What each method is."""


@dataclass(frozen=True, eq=False)
class Answer:
    """What one method says.

    Attributes
    ----------
    calibration : Calibration
        Named after its method.
    lines, surfaces : int
        That the answer rests on.
    against : Difference or None
        From the first answer to this one; None for the first.
    remarks : tuple of str
    """

    calibration: Calibration
    lines: int
    surfaces: int
    against: Difference | None
    remarks: tuple[str, ...]

    @property
    def method(self) -> str:
        """Its name."""
        return self.calibration.name


def answers(project: Project) -> tuple[Answer, ...]:
    """The answers that there are, that of the targets first; each is held against the first."""
    found: list[Answer] = []

    def add(said: Calibration, lines: int, surfaces: int, remarks: tuple[str, ...]) -> None:
        against = difference(found[0].calibration, said) if found else None
        found.append(Answer(said, lines, surfaces, against, remarks))

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
    """Methods that have not been asked yet."""
    return tuple(method for method in METHODS if project.opinion(method) is None)


def sentences(found: tuple[Answer, ...]) -> tuple[str, ...]:
    """What is to be thought of the answers."""
    if len(found) < 2:
        return ()
    said = [_verdict(each.against) for each in found if each.against is not None]
    return (*said, SHARED)


def _verdict(against: Difference) -> str:
    one, other = against.second.capitalize(), against.first
    moved = f"{100 * against.displacement(FAR):.1f}"
    if not against.differ:
        return f"{one} and {other} agree: a point {FAR:.0f} m away moves by {moved} cm."
    which = [name for name, yes in zip(ANGLES, against.significant, strict=True) if yes]
    where = f"in {listed(which)}" if which else "all angles together"
    return (
        f"{one} and {other} differ by more than their sigmas explain, {where}: a point "
        f"{FAR:.0f} m away moves by {moved} cm."
    )
