"""Results for others: report, georeferenced lines, data, script, manual."""
