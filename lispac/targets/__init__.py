"""Search for a plane or sphere on every line, starting from a seed."""
