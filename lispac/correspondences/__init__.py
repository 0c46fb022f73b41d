"""Boresight from point correspondences between lines, for terrain without planes."""
