"""What stands around the 3D view."""
