"""Readers of points in formats other than LAS, and code shared by all readers of points."""
