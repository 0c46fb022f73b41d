"""Simulated points of balls, masts and walls seen by a scanner at the origin."""

import numpy as np

from lispac.geometry.spheres import Sphere

CENTRE = np.array([0.0, 20.0, 4.0])  # centre of a ball, seen from the origin of the frame
BALL = Sphere(CENTRE, 0.1)
MAST, WALL = -1, -2  # labels in addition to those of the balls, which count from 0


def to_sphere(rays, sphere):
    """Range along each ray to a sphere, infinite where it misses."""
    along = rays @ sphere.centre
    discriminant = sphere.radius**2 - (sphere.centre @ sphere.centre - along**2)
    return np.where(discriminant >= 0.0, along - np.sqrt(np.maximum(discriminant, 0.0)), np.inf)


def to_mast(rays, foot, radius):
    """Range along each ray to an upright post that ends at ``foot``."""
    level = np.linalg.norm(rays[:, :2], axis=1)
    along = (rays[:, :2] @ foot[:2]) / level
    discriminant = radius**2 - (foot[:2] @ foot[:2] - along**2)
    reach = (along - np.sqrt(np.maximum(discriminant, 0.0))) / level
    return np.where((discriminant >= 0.0) & (reach * rays[:, 2] <= foot[2]), reach, np.inf)


def cast(rng, balls, *, mast=None, wall=None, noise=0.002, mixed=0.5, step=(0.006, 0.012)):
    """Points around CENTRE as seen by a scanner at the origin, and their labels.

    A beam at an edge hits both surfaces: its range lies between the two ("mixed pixel").
    """
    x, z = (np.arange(-0.9, 0.9, s) / CENTRE[1] for s in step)
    turn = np.arctan2(CENTRE[2], CENTRE[1])
    flat = np.stack(np.meshgrid(x, z + turn, indexing="ij"), axis=-1)
    rays = np.stack([np.sin(flat[..., 0]), np.cos(flat[..., 0]) * np.cos(flat[..., 1]),
                     np.cos(flat[..., 0]) * np.sin(flat[..., 1])], axis=-1)  # fmt: skip
    shape, rays = rays.shape[:2], rays.reshape(-1, 3)
    ranges = [to_sphere(rays, ball) for ball in balls]
    ranges.append(np.full(len(rays), np.inf) if mast is None else to_mast(rays, *mast))
    ranges.append(np.full(len(rays), np.inf) if wall is None else wall / rays[:, 1])
    hit = np.min(ranges, axis=0)
    names = np.array([*range(len(balls)), MAST, WALL])
    label = names[np.argmin(ranges, axis=0)].reshape(shape)
    reach = hit.reshape(shape)
    blurred = reach.copy()
    for axis in (0, 1):
        beside = np.roll(reach, 1, axis)
        edge = (np.roll(label, 1, axis) != label) & np.isfinite(beside) & np.isfinite(reach)
        edge &= rng.random(shape) < mixed
        blurred[edge] += rng.uniform(0.0, 0.5, np.count_nonzero(edge)) * (
            beside[edge] - reach[edge]
        )
    is_hit = np.isfinite(blurred).ravel()
    noisy = blurred.ravel() + rng.normal(0.0, noise, len(rays))
    return (noisy[:, None] * rays)[is_hit], label.ravel()[is_hit]


def front(sphere, *, off=(0.0, 0.0), gap=0.0):
    """A place on the side towards the scanner, ``off`` radii north and up from the centre."""
    towards = -sphere.centre / np.linalg.norm(sphere.centre)
    direction = towards + off[0] * np.array([1.0, 0.0, 0.0]) + off[1] * np.array([0.0, 0.0, 1.0])
    return sphere.centre + (sphere.radius + gap) * direction / np.linalg.norm(direction)
