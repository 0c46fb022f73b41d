"""Preferences of the user and the library of sensors."""
