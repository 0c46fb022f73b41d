"""Storage of a line on disk in columns in spatial order, from which single regions can be read."""
