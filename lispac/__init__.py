"""LISPAC: boresight calibration of mobile LiDAR systems."""

__version__ = "0.1.0"
