"""From a seed to a plane or sphere on every line."""
