"""The LiDAR patch test."""
