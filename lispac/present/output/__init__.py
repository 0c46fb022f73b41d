"""Values for other programs, as values, tables and texts."""
