"""Manual, tour, and information about the program."""
