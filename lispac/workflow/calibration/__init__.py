"""Calibration workflow: picking of targets, estimation of the boresight, alternative methods."""
