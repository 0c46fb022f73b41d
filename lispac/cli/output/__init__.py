"""Commands that write reports and files for other programs."""
