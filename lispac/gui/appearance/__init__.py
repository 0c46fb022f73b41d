"""Theme, colours and units of the window."""
