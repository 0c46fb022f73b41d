"""Trajectory, scan, georeferencing: how a point comes into the local frame."""
