"""Reading and writing of projects on disk."""
