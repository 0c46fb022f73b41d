"""Surveyed control of a project: files of points, assigned to targets, that the adjustment uses."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from lispac.adjustment.model.control import Control
from lispac.errors import InputError, ProjectError
from lispac.messages import Message, error
from lispac.picked_targets import Triple

SIGMA_LIMITS = (1e-6, 10.0)
"""Smallest and largest standard deviation of a control point, metres."""
FRAME_TOLERANCE = 1e-4
"""Largest difference between two origins of the local frame that are the same, metres."""
METRES_PER_DEGREE = 111_320.0
"""Approximate length of a degree of latitude, metres."""


@dataclass(frozen=True)
class ControlPoint:
    """A surveyed point.

    Attributes
    ----------
    name : str
    target : str
        Target on which the point lies; empty if it was not assigned.
    position : metres, local frame (north, west, up)
    sigmas : metres, standard deviations north, west and up
    is_centre : bool
        Whether the point is the centre of a sphere instead of a point on the surface.
    used : bool
        Whether the adjustment uses the point, if it is assigned.
    reason : Message or None
        Reason why the point was not assigned to a target; None if it was.
    """

    name: str
    target: str
    position: Triple
    sigmas: Triple
    is_centre: bool = False
    used: bool = True
    reason: Message | None = None


@dataclass(frozen=True)
class ControlFile:
    """The control of one file.

    Attributes
    ----------
    path : Path
    size_bytes : int
    sha256 : str
    kind : {"scan", "points"}
    system : str
        Coordinate system as text.
    origin_deg_m : latitude, longitude (degrees) and height (metres) of the local frame
    common_sigma : float, metres
        Standard deviation, on each axis, of a translation that all points of the file share.
    points : tuple of ControlPoint
    """

    path: Path
    size_bytes: int
    sha256: str
    kind: str
    system: str
    origin_deg_m: Triple
    common_sigma: float
    points: tuple[ControlPoint, ...]

    @property
    def used_points(self) -> tuple[ControlPoint, ...]:
        """Points that are assigned to a target and used."""
        return tuple(each for each in self.points if each.used and each.target)

    def require_sound(self) -> None:
        """Refuse values that cannot be adjusted.

        Raises
        ------
        InputError
            If a coordinate is not finite, or a standard deviation is not within `SIGMA_LIMITS`.
        """
        low, high = SIGMA_LIMITS
        if not (np.isfinite(self.common_sigma) and 0.0 <= self.common_sigma <= high):
            raise InputError(
                error("control.common_sigma_out_of_range", value=self.common_sigma, most=high)
            )
        for point in self.points:
            if not np.isfinite(point.position).all():
                raise InputError(error("control.position_not_finite", name=point.name))
            for sigma in point.sigmas:
                if not low <= sigma <= high:
                    raise InputError(
                        error(
                            "control.sigma_out_of_range",
                            name=point.name, value=sigma, least=low, most=high,
                        )
                    )  # fmt: skip


def control_observations(
    files: Sequence[ControlFile], targets: Collection[str], origin_deg_m: Triple
) -> Control | None:
    """Control of some targets for the adjustment; None if there is none.

    Parameters
    ----------
    origin_deg_m : latitude, longitude (degrees) and height (metres) of the present local frame

    Raises
    ------
    InputError
        If a file was imported with another origin of the local frame.
    """
    points = [
        (file, point)
        for file in files
        for point in file.used_points
        if point.target in targets
    ]  # fmt: skip
    if not points:
        return None
    for file in files:
        if file.used_points and not _is_same_origin(file.origin_deg_m, origin_deg_m):
            raise InputError(error("control.other_origin", file=file.path.name))
    return Control.of(
        [point.name for _, point in points],
        [point.target for _, point in points],
        np.array([point.position for _, point in points]),
        np.array([np.diag(np.square(point.sigmas)) for _, point in points]),
        is_centre=np.array([point.is_centre for _, point in points]),
        sources=[file.path.name for file, _ in points],
        common_sigmas={file.path.name: file.common_sigma for file in files},
    )


def with_control_file(files: Sequence[ControlFile], added: ControlFile) -> tuple[ControlFile, ...]:
    """Add a file, or replace the one with the same name."""
    others = tuple(file for file in files if file.path.name != added.path.name)
    return (*others, added)


def without_control_file(files: Sequence[ControlFile], name: str) -> tuple[ControlFile, ...]:
    """Remove a file by its name.

    Raises
    ------
    ProjectError
        If there is no such file.
    """
    if name not in {file.path.name for file in files}:
        raise ProjectError(error("control.unknown_file", name=name))
    return tuple(file for file in files if file.path.name != name)


def with_control_use(
    files: Sequence[ControlFile], names: Collection[str], *, used: bool
) -> tuple[ControlFile, ...]:
    """Use or exclude the points of these names.

    Raises
    ------
    ProjectError
        If a name is unknown.
    """
    known = {point.name for file in files for point in file.points}
    if unknown := [name for name in names if name not in known]:
        raise ProjectError(error("control.unknown_point", name=unknown[0]))
    return tuple(
        replace(
            file,
            points=tuple(
                replace(point, used=used) if point.name in names else point for point in file.points
            ),
        )
        for file in files
    )


def with_renamed_target(
    files: Sequence[ControlFile], old: str, new: str
) -> tuple[ControlFile, ...]:
    """Control of a target under its new name."""
    return tuple(
        replace(
            file,
            points=tuple(
                replace(point, target=new) if point.target == old else point
                for point in file.points
            ),
        )
        for file in files
    )


def _is_same_origin(one: Triple, other: Triple) -> bool:
    north, east, up = np.subtract(one, other)
    off = np.array([north * METRES_PER_DEGREE, east * METRES_PER_DEGREE, up])
    return bool(np.abs(off).max() <= FRAME_TOLERANCE)
