"""Import dialogue: survey files are added, examined and checked, and a project is created."""
