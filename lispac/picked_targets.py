"""Picked targets and validation planes, with their points on every line."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError
from lispac.messages import Message, error
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices

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
        Indices into the points of the line: the points of its file within the trajectory's time.
    fingerprint : str
        `Scan.fingerprint` of the points of the line. The sighting is refused if the line has other
        points later, for example after it is read with other options.
    rms : float, metres
        Root mean square distance of the points from the plane or sphere fitted to them.
    used : bool
        Whether the sighting is used.
    one_in : int
        Sampling of the points around the seed during the search: one in this number was used; 1 if
        all were used.
    by_hand : bool
        Whether the user added or removed points; the points are then not selected again.
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
    missing : reason for each line on which the target was not found
    shape : {"plane", "sphere"}
    sphere_radius : metres, or None if unknown
    expected : size and inclination of the plane, if known in advance
    choices : other options of the search, used when the points are selected again
    """

    name: str
    role: Role
    seed: Triple
    threshold: float
    radius: float
    sightings: tuple[PickedSighting, ...]
    used: bool = True
    missing: Mapping[str, Message] = field(default_factory=dict)
    shape: Shape = "plane"
    sphere_radius: float | None = None
    expected: ExpectedTarget | None = None
    choices: FinderChoices = DEFAULT_CHOICES

    def sighting(self, line: str) -> PickedSighting | None:
        """Sighting on ``line``; None if there is none."""
        return next((s for s in self.sightings if s.line == line), None)

    @property
    def used_sightings(self) -> tuple[PickedSighting, ...]:
        """Sightings that are used."""
        return tuple(s for s in self.sightings if s.used) if self.used else ()


MAX_NAME_LENGTH = 40
"""Largest number of characters in the name of a target."""


def require_target_name(name: str) -> None:
    """Refuse a name of a target that cannot be used in a table or a file name.

    Raises
    ------
    ProjectError
        If the name is empty or too long, or contains a character that is not allowed.
    """
    if not name.strip() or len(name) > MAX_NAME_LENGTH or not name.isprintable():
        shown = repr(name[:MAX_NAME_LENGTH])
        raise ProjectError(error("target.invalid_name", name=shown, longest=MAX_NAME_LENGTH))
    if any(character in name for character in "/\\:"):
        raise ProjectError(error("target.name_with_separator", name=name))


def require_valid_target(target: Target) -> None:
    """Refuse a target with an invalid name or shape.

    Raises
    ------
    ProjectError
        If the name is invalid, or the radius or the role does not suit the shape.
    """
    require_target_name(target.name)
    radius = target.sphere_radius
    if radius is not None and target.shape != "sphere":
        raise ProjectError(error("target.plane_with_radius", target=target.name))
    if radius is not None and not 0 < radius < np.inf:
        raise ProjectError(error("target.invalid_radius", target=target.name, radius=radius))
    if target.shape == "sphere" and target.role == "validation":
        raise ProjectError(error("target.validation_sphere", target=target.name))
