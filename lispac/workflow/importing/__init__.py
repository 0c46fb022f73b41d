"""Import of a survey: input files, their formats and times, and the lines of a project."""
