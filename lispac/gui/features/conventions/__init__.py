"""The boresight in the angle conventions of other programs."""
