"""Targets and their sightings, as values and tables."""
