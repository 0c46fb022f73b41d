"""Points, targets and tables as text."""
