"""Step 5: the report."""
