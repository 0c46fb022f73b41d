"""Dialogues of the window."""
