"""Step 3: the adjustment and its results."""
