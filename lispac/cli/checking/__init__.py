"""Commands that check a calibration and compare calibrations."""
