"""Projects: creation, opening, saving and copying, and their survey."""
