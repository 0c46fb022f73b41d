"""Checks before a release that need minutes, the network or root."""
