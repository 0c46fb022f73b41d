"""Diagnostics of a solution: reliability, observability, cross-checks, causes, warnings."""
