"""Rotations, frames, planes, spheres and neighbour searches."""
