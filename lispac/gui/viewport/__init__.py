"""The 3D view, of which only `vtk` and `actors` know VTK."""
