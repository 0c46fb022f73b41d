"""Step 4: distances between the lines on validation planes."""
