"""Boresight and lever arm in the conventions of other programs."""
