"""Checks that take minutes to hours, the network or root; started by hand before a release."""
