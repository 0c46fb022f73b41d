"""The LiDAR patch test: lines laid onto each other about objects that they share."""
