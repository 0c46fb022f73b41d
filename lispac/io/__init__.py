"""Reading and writing files: one module per format, without computations."""
