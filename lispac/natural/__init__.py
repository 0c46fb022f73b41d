"""Natural surfaces: pieces of the scene that serve as targets where none was hung."""
