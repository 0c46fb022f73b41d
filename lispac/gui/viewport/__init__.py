"""3D view of the lines; only some of its modules depend on VTK."""
