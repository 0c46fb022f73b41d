"""Export of lines, targets, trajectory and script."""
