"""Studies of a result, and results of alternative methods."""
