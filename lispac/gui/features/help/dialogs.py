"""Dialogues about the program."""

from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.help.about import about_box, shortcuts_box


class HelpDialogs(Questions):
    """Dialogues about the program."""

    def about(self) -> None:
        """Show version, conventions and licence of the program."""
        run_dialog(about_box(self.parent))

    def shortcuts(self) -> None:
        """Show the mouse and keyboard commands."""
        run_dialog(shortcuts_box(self.parent))
