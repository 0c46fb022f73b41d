"""Static scans of the built-in port: true surfaces sampled with known noise and shifts."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.simulation.port_scene import port_scene
from lispac.simulation.scene import Rectangle

Array = NDArray[np.float64]
PLANES = ("T1", "T2", "V1", "V2", "V3", "V4", "V5")


def plane_of(name: str) -> Rectangle:
    """True plane with this name."""
    plane = port_scene()[name]
    assert isinstance(plane, Rectangle)
    return plane


def on_plane(name: str, across: Array, up: Array) -> Array:
    """Places on a true plane, given as fractions of its sides from its centre, (n, 3), metres."""
    plane = plane_of(name)
    along = np.cross(plane.normal, plane.across)
    return (
        plane.centre
        + np.outer(across * plane.width, plane.across)
        + np.outer(up * plane.height, along)
    )


def tripod_scan(
    names: tuple[str, ...] = PLANES,
    *,
    noise: float = 0.002,
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0),
    density: float = 100.0,
) -> Array:
    """Evenly spread points of true planes with noise along their normals, shape (n, 3)."""
    rng, parts = np.random.default_rng(4), []
    for name in names:
        plane = plane_of(name)
        n = int(density * plane.width * plane.height)
        points = on_plane(name, *rng.uniform(-0.5, 0.5, (2, n)))
        parts.append(points + np.outer(rng.normal(0.0, noise, n), plane.normal))
    return np.concatenate(parts) + shift


def write_pts(path: Path, blocks: Sequence[Array], *, more: int = 4) -> Path:
    """Write Leica PTS like Cyclone; ``more`` columns are intensity, red, green and blue."""
    with path.open("w") as file:
        for points in blocks:
            file.write(f"{len(points)}\n")
            others = np.tile([-1035, 97, 59, 38][:more], (len(points), 1))
            rows = np.column_stack([points, others])
            np.savetxt(file, rows, fmt=["%.5f"] * 3 + ["%d"] * more)
    return path
