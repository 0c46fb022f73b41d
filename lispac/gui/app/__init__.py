"""Services of the window: settings, tasks, actions, questions to the user."""
