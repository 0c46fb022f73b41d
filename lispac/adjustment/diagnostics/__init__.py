"""What the solution is worth: reliability, observability, cross-checks, causes, warnings."""
