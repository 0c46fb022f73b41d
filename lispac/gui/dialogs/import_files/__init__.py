"""The import dialogue: files in, looked at, checked against each other, and a project made."""
