"""Surveyed control of a project: files of points, assigned to targets, that the adjustment uses."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.control import Control
from lispac.errors import InputError, ProjectError
from lispac.messages import Message, error, note
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
    stated_target : str
        Name of its target in the file; empty if the file does not state it.
    correlations : no unit
        Correlations of north and west, north and up, and west and up.
    """

    name: str
    target: str
    position: Triple
    sigmas: Triple
    is_centre: bool = False
    used: bool = True
    reason: Message | None = None
    stated_target: str = ""
    correlations: Triple = (0.0, 0.0, 0.0)

    @property
    def covariance(self) -> NDArray[np.float64]:
        """Covariance of the coordinates, shape (3, 3), square metres, local frame."""
        first, second, third = self.correlations
        matrix = np.array([[1.0, first, second], [first, 1.0, third], [second, third, 1.0]])
        return np.outer(self.sigmas, self.sigmas) * matrix


@dataclass(frozen=True)
class ControlReading:
    """Options with which a file of control is read; empty or None as in the file or the project."""

    crs: str = ""
    height: str = ""
    trajectory_datum: str | None = None
    epoch: float | None = None


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
    reading : ControlReading
    assigned_to : tuple of str
        Targets to which the points were assigned, or which were searched in the scan. A target that
        is not among them is new.
    """

    path: Path
    size_bytes: int
    sha256: str
    kind: str
    system: str
    origin_deg_m: Triple
    common_sigma: float
    points: tuple[ControlPoint, ...]
    reading: ControlReading = ControlReading()
    assigned_to: tuple[str, ...] = ()

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
            if not np.linalg.eigvalsh(point.covariance)[0] > 0:
                raise InputError(error("control.sigma_not_positive", name=point.name))


def controlled_targets(files: Sequence[ControlFile]) -> frozenset[str]:
    """Targets with control that is used."""
    return frozenset(point.target for file in files for point in file.used_points)


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
        np.array([point.covariance for _, point in points]),
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
            assigned_to=tuple(new if name == old else name for name in file.assigned_to),
        )
        for file in files
    )


def without_assignment(
    files: Sequence[ControlFile], targets: Collection[str]
) -> tuple[ControlFile, ...]:
    """Control that is no longer assigned to some targets, which were removed or replaced.

    Listed points may belong to another target, so that they are to be assigned again. The points of
    a scan are removed, because they represent a surface.
    """
    return tuple(
        _without_assignment(file, targets)
        if {*targets} & {*file.assigned_to, *(point.target for point in file.points)}
        else file
        for file in files
    )


def _without_assignment(file: ControlFile, targets: Collection[str]) -> ControlFile:
    if file.kind == "scan":
        return replace(
            file,
            points=tuple(p for p in file.points if (p.target or p.stated_target) not in targets),
            assigned_to=tuple(name for name in file.assigned_to if name not in targets),
        )
    points = tuple(
        replace(
            point, target="", is_centre=False,
            reason=note("control.target_removed", name=point.name, target=point.target),
        )
        if point.target in targets else point
        for point in file.points
    )  # fmt: skip
    return replace(file, points=points, assigned_to=())


def _is_same_origin(one: Triple, other: Triple) -> bool:
    north, east, up = np.subtract(one, other)
    off = np.array([north * METRES_PER_DEGREE, east * METRES_PER_DEGREE, up])
    return bool(np.abs(off).max() <= FRAME_TOLERANCE)
