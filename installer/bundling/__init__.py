"""Build of the bundle: a release folder that runs without an installed Python; see `build.py`."""
