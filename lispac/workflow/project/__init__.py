"""Projects: making, opening, saving and copying them, and their survey."""
