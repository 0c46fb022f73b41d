"""Commands that create a project and manage its files."""
