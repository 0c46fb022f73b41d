"""Features of the window, one folder each: panels, dialogues and controller."""
