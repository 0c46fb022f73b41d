"""Panels around the 3D view."""
