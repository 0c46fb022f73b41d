"""The open project: document and undo history, computations and what the view shows."""
