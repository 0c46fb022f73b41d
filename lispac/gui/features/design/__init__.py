"""The window for the design of a survey."""
