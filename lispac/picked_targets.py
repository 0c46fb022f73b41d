"""Picked targets and validation planes, with their points on every line."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError
from lispac.messages import Message, error
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import USUAL, FinderChoices

Role = Literal["target", "validation"]
ROLES: tuple[Role, ...] = ("target", "validation")
Shape = Literal["plane", "sphere"]
SHAPES: tuple[Shape, ...] = ("plane", "sphere")
Triple = tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class PickedSighting:
    """The points of one target on one line.

    Attributes
    ----------
    indices : ndarray of shape (n,), int64
        Into the line's points: those of its file that lie within the trajectory.
    fingerprint : str
        `Scan.fingerprint` of these points; a line read otherwise later is refused.
    rms : float, metres
        Of the points about their own plane.
    used : bool
        Whether the sighting takes part.
    one_in : int
        Of how many points about the seed one was examined: 1 where all were.
    by_hand : bool
        Whether points were added or taken away by hand; they are then not selected again.
    """

    line: str
    indices: NDArray[np.int64]
    rms: float
    used: bool = True
    fingerprint: str = ""
    one_in: int = 1
    by_hand: bool = False


@dataclass(frozen=True, eq=False)
class Target:
    """A picked plane or sphere.

    Attributes
    ----------
    seed : metres, local frame, where the user clicked
    threshold, radius : float, metres
        RANSAC distance threshold, and search radius about the seed.
    missing : for each line without it, the reason
    shape : {"plane", "sphere"}
    sphere_radius : metres, or None where it is unknown
    expected : what is known of a plane's size and inclination beforehand
    choices : what of the finder was chosen; the points are selected again with it
    """

    name: str
    role: Role
    seed: Triple
    threshold: float
    radius: float
    sightings: tuple[PickedSighting, ...]
    missing: Mapping[str, Message] = field(default_factory=dict)
    used: bool = True
    shape: Shape = "plane"
    sphere_radius: float | None = None
    expected: ExpectedTarget | None = None
    choices: FinderChoices = USUAL

    def sighting(self, line: str) -> PickedSighting | None:
        """The sighting on ``line``, if there is one."""
        return next((s for s in self.sightings if s.line == line), None)

    @property
    def used_sightings(self) -> tuple[PickedSighting, ...]:
        """Sightings that take part."""
        return tuple(s for s in self.sightings if s.used) if self.used else ()

    @property
    def is_compared(self) -> bool:
        """True if the target is used on at least two lines, so that they can be compared."""
        return len(self.used_sightings) >= 2


LONGEST_NAME = 40


def require_target_name(name: str) -> None:
    """Refuse a name of a target that cannot stand in a table or a file name.

    Raises
    ------
    ProjectError
    """
    if not name.strip() or len(name) > LONGEST_NAME or not name.isprintable():
        shown = repr(name[:LONGEST_NAME])
        raise ProjectError(error("target.invalid_name", name=shown, longest=LONGEST_NAME))
    if any(character in name for character in "/\\:"):
        raise ProjectError(error("target.name_with_separator", name=name))


def require_valid_target(target: Target) -> None:
    """Refuse a target whose name or shape cannot be worked with.

    Raises
    ------
    ProjectError
    """
    require_target_name(target.name)
    radius = target.sphere_radius
    if radius is not None and target.shape != "sphere":
        raise ProjectError(error("target.plane_with_radius", target=target.name))
    if radius is not None and not 0 < radius < np.inf:
        raise ProjectError(error("target.invalid_radius", target=target.name, radius=radius))
    if target.shape == "sphere" and target.role == "validation":
        raise ProjectError(error("target.validation_sphere", target=target.name))
