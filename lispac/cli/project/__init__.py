"""Commands that make a project and manage its files."""
