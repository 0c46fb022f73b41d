"""Local model of a surface between the points of a cloud: point, plane or quadric.

The local models are those of CloudCompare.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.nearest_neighbours import local_planes
from lispac.geometry.quadrics import heights_above, local_quadrics
from lispac.messages import Message, error, note

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
Kind = Literal["point", "plane", "quadric"]

MIN_POINTS_BY_KIND = {"point": 1, "plane": 3, "quadric": 6}
"""Smallest number of points that determine each model."""
DEFAULT_NEIGHBOURS: dict[Kind, int] = {"point": 1, "plane": 6, "quadric": 12}
"""Default number of points for each model; six for a plane, as in CloudCompare."""


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
    neighbours: int = 6
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

    def distances(
        self, compared: Array, nearest: Indices, reference: Array, tree: "cKDTree"
    ) -> Array:
        """Unsigned distance of each compared point to the surface at its nearest point.

        Parameters
        ----------
        compared : ndarray of shape (n, 3), metres, local frame
        nearest : ndarray of shape (n,)
            Index of the reference point nearest to each compared point.
        reference : ndarray of shape (m, 3), metres, local frame
        tree : cKDTree of the reference points

        Returns
        -------
        ndarray of shape (n,), metres
            NaN where the neighbours determine no surface, and for ``kind`` "point".
        """
        if self.kind == "point":
            return np.full(len(compared), np.nan)
        # Several compared points may have the same nearest point, and therefore the same surface.
        centres, surface_of = np.unique(nearest, return_inverse=True)
        groups, counts = self._neighbour_groups(reference, centres, tree)
        centroids, normals = local_planes(reference, groups, counts)
        offsets = compared - centroids[surface_of]
        if self.kind == "plane":
            return np.abs(np.einsum("ij,ij->i", offsets, normals[surface_of]))
        quadrics = local_quadrics(reference, groups, counts, centroids, normals)
        return np.abs(heights_above(quadrics, offsets, surface_of))

    def _neighbour_groups(
        self, reference: Array, centres: Indices, tree: "cKDTree"
    ) -> tuple[Indices, Indices]:
        """Neighbours (c, k) of the given points, and the number of valid entries in each row."""
        if self.radius is None:
            k = min(self.neighbours, len(reference))
            _, found = tree.query(reference[centres], k=range(1, k + 1))
            return np.asarray(found, dtype=np.intp), np.full(len(centres), k, dtype=np.intp)
        lists = tree.query_ball_point(reference[centres], self.radius)
        counts = np.fromiter(map(len, lists), dtype=np.intp, count=len(lists))
        padded = np.zeros((len(lists), int(counts.max(initial=1))), dtype=np.intp)
        padded[np.arange(padded.shape[1]) < counts[:, None]] = np.concatenate(lists)
        return padded, counts


NEAREST_POINT_MODEL = LocalModel("point", 1)
"""Nearest point only; distances then depend on the point spacing as well."""
SIX_POINT_PLANE = LocalModel("plane", 6)
"""Default model of CloudCompare and of this program."""
