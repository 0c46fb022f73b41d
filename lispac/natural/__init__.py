"""Natural planes: flat surfaces of the scene used as targets."""
