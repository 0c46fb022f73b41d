"""Comparisons of lines with each other and with references, as values and tables."""
