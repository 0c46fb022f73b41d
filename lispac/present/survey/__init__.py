"""Input files, lines, sensors and points of a survey, as values and tables."""
