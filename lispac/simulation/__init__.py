"""Simulated surveys with known truth, and effects of errors on a board."""
