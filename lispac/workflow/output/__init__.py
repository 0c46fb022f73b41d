"""Output of results: report, georeferenced lines, data, script, manual."""
