"""What makes the folder of a release that runs without Python; `build.py` builds it."""
