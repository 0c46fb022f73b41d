"""The list of warnings."""
