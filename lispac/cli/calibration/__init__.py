"""Commands from seeds to the boresight."""
