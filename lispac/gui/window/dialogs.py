"""All dialogues of the window in one class, which tests replace."""

from lispac.gui.window.features import FEATURES


class Dialogs(*(each.dialogs for each in FEATURES if each.dialogs is not None)):
    """Shows the dialogues of all features and returns the answers of the user."""
