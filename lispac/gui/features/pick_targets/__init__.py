"""Step 2: picking, detecting and editing targets."""
