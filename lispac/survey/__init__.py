"""Trajectory, scan, georeferencing: how points are placed in the local frame."""
