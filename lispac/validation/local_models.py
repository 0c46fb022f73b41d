"""Local model of a surface between the points of a cloud: point, plane or quadric.

The local models are those of CloudCompare.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import InputError
from lispac.geometry.local_planes import local_planes
from lispac.geometry.point_tree import PointTree
from lispac.geometry.quadrics import Quadrics, heights_above, local_quadrics
from lispac.messages import Message, error, note

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Kind = Literal["point", "plane", "quadric"]

MIN_POINTS_BY_KIND = {"point": 1, "plane": 3, "quadric": 6}
"""Smallest number of points that determine each model."""
DEFAULT_NEIGHBOURS: dict[Kind, int] = {"point": 1, "plane": 40, "quadric": 60}
"""Default number of points for each model.

The default of CloudCompare, six, is too small for lines: the nearest points lie along one profile,
or are closer together than the noise, and the plane through them is inclined at random. In
simulations with 500 to 40,000 points per square metre, noise of 2 and 5 mm and profiles up to 20
times as far apart as their points, the RMS for an offset of 21 mm is 0.54 to 1.09 times the true
one with 6 points and 0.94 to 1.03 times with 40 (`tests.studies.surface_models`)."""


@dataclass(frozen=True)
class LocalModel:
    """Model of the surface to which distances are measured, and the points it is fitted to.

    Attributes
    ----------
    kind : "point", "plane" or "quadric"
        The nearest point itself, or a surface fitted by least squares to it and its neighbours.
    neighbours : int
        Number of points, including the nearest one.
    radius : float, metres, optional
        If given, all points within this distance of the nearest one are used instead.

    Raises
    ------
    InputError
        If the kind is unknown, the neighbours are too few to determine the model, or the radius is
        not positive.
    """

    kind: Kind = "plane"
    neighbours: int = DEFAULT_NEIGHBOURS["plane"]
    radius: float | None = None

    def __post_init__(self) -> None:
        if self.kind not in MIN_POINTS_BY_KIND:
            raise InputError(
                error("validation.unknown_model", kind=self.kind, kinds=tuple(MIN_POINTS_BY_KIND))
            )
        if self.radius is not None and not 0.0 < self.radius < np.inf:
            raise InputError(error("validation.model_radius", kind=self.kind, radius=self.radius))
        if self.radius is None and self.neighbours < MIN_POINTS_BY_KIND[self.kind]:
            raise InputError(
                error(
                    "validation.model_neighbours",
                    kind=self.kind,
                    needed=MIN_POINTS_BY_KIND[self.kind],
                    count=self.neighbours,
                )
            )

    @property
    def name(self) -> Message:
        """Name of the model in tables and reports."""
        if self.kind == "point":
            return note("surface.nearest_point")
        flat = self.kind == "plane"
        if self.radius is not None:
            code = "surface.plane_within" if flat else "surface.quadric_within"
            return note(code, radius=self.radius)
        return note("surface.plane" if flat else "surface.quadric", count=self.neighbours)

    def distances(self, compared: Array, nearest: Indices, reference: PointTree) -> Array:
        """Unsigned distance of each compared point to the surface at its nearest point.

        Parameters
        ----------
        compared : ndarray of shape (n, 3), metres, local frame
        nearest : ndarray of shape (n,)
            Index in ``reference.points`` of the point nearest to each compared point.
        reference : PointTree, local frame

        Returns
        -------
        ndarray of shape (n,), metres
            NaN where the neighbours determine no surface, and for ``kind`` "point".
        """
        if self.kind == "point":
            return np.full(len(compared), np.nan)
        # Several compared points may have the same nearest point, and therefore the same surface.
        centres, surface_of = _number_surfaces(nearest)
        return self.surfaces(reference, reference.points[centres]).distances(compared, surface_of)

    def surfaces(self, reference: PointTree, places: Array) -> "LocalSurfaces":
        """Planes or quadrics fitted to the points of a cloud around some of them.

        Parameters
        ----------
        reference : PointTree, local frame
        places : ndarray of shape (c, 3), metres, local frame
            Points of the cloud.
        """
        groups, counts = self._neighbour_groups(reference, places)
        centroids, normals = local_planes(reference.points, groups, counts)
        quadrics = None
        if self.kind == "quadric":
            quadrics = local_quadrics(reference.points, groups, counts, centroids, normals)
        return LocalSurfaces(centroids, normals, quadrics)

    def _neighbour_groups(self, reference: PointTree, places: Array) -> tuple[Indices, Indices]:
        """Neighbours (c, k) of the given points, and the number of valid entries in each row."""
        if self.radius is not None:
            return reference.within(places, self.radius)
        k = min(self.neighbours, len(reference))
        return reference.neighbours(places, k)[1], np.full(len(places), k, dtype=np.int64)


@dataclass(frozen=True, eq=False)
class LocalSurfaces:
    """Surfaces fitted to points of a cloud, see `LocalModel.surfaces`.

    Attributes
    ----------
    centroids : ndarray of shape (c, 3), metres, local frame
    normals : ndarray of shape (c, 3), unit vectors, local frame
        Of the planes; NaN where the neighbours determine none.
    quadrics : Quadrics or None
        Heights over these planes; None if the surfaces are the planes.
    """

    centroids: Array
    normals: Array
    quadrics: Quadrics | None

    def distances(self, compared: Array, surface_of: Indices) -> Array:
        """Unsigned distance of each compared point to its surface.

        Parameters
        ----------
        compared : ndarray of shape (n, 3), metres, local frame
        surface_of : ndarray of shape (n,)
            Index of the surface of each point.

        Returns
        -------
        ndarray of shape (n,), metres
            NaN where there is no surface.
        """
        offsets = compared - self.centroids[surface_of]
        if self.quadrics is None:
            return np.abs(np.einsum("ij,ij->i", offsets, self.normals[surface_of]))
        return np.abs(heights_above(self.quadrics, offsets, surface_of))


@njit(nogil=True, cache=True)
def _number_surfaces(
    nearest: Indices,
) -> tuple[Indices, Indices]:  # pragma: no cover - compiled
    """Distinct indices (c,), and for each given index (n,) its position among them.

    Unlike `numpy.unique`, it does not sort: a table keeps the position of the last index of each
    slot. An index that was replaced in the meantime occurs twice, which only costs time.
    """
    slots = 1024
    while slots < len(nearest):
        slots *= 2
    latest = np.full(slots, -1, np.int64)
    distinct = np.empty(len(nearest), np.int64)
    numbers = np.empty(len(nearest), np.int64)
    count = 0
    for i in range(len(nearest)):
        slot = nearest[i] & (slots - 1)
        if latest[slot] < 0 or distinct[latest[slot]] != nearest[i]:
            distinct[count] = nearest[i]
            latest[slot] = count
            count += 1
        numbers[i] = latest[slot]
    return distinct[:count].copy(), numbers


NEAREST_POINT_MODEL = LocalModel("point", 1)
"""Nearest point only; distances then depend on the point spacing as well."""
SIX_POINT_PLANE = LocalModel("plane", 6)
"""Default model of CloudCompare, and of the first versions of this program."""
DEFAULT_MODEL = LocalModel()
"""Default model of validations."""
