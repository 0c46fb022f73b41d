"""The open project: document, undo history, computations, and content of the 3D view."""
