"""Results of an adjustment and of other methods, as values and tables."""
