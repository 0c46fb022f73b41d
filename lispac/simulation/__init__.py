"""Surveys with a known truth, and what an error does to a board."""
