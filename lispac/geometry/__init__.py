"""Rotations, frames, planes, spheres, neighbours."""
