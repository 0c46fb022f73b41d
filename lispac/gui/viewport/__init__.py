"""3D view of the lines; only a few of its modules depend on VTK."""
