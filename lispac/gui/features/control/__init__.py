"""Surveyed control of the adjustment."""
