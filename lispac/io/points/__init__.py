"""Points in other formats, and what all readers of points share."""
