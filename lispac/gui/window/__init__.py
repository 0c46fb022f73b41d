"""The main window: assembled from the features."""
