"""Results of survey planning, as values and tables."""
