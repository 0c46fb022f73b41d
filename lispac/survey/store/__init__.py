"""A line on disk: columns in the order of space, of which a region is read without the rest."""
