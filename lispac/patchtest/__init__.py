"""LiDAR patch test: align lines with each other at objects that they share."""
