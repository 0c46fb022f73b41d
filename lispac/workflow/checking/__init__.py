"""Checks of a calibration: validation, references, warnings, history."""
