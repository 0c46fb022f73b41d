"""Surveyed references: reading, and control of the adjustment."""
