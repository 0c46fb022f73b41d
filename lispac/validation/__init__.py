"""Distances between lines on surfaces not used in the adjustment, before and after."""
