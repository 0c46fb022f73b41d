"""What makes the folder of a release that runs without Python; installer/bundle.py builds it."""
