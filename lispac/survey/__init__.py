"""Trajectories, scans and georeferencing of points in the local frame."""
