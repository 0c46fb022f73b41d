"""Commands that design and simulate surveys."""
