"""The workspace in which a calibration site is designed."""
