"""The other role for the selected target."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.gui.actions import Actions
from lispac.gui.document import Document
from lispac.gui.scene import Scene
from lispac.workflow import edits

NOTHING_SELECTED = "Select a target or validation plane first; then change its role"


class Roles(QObject):
    """Makes a validation plane of a target, or a target of a validation plane."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        actions: Actions,
        note: Callable[[str], None],
        refuse: Callable[[LispacError], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene = document, scene
        self._note, self._refuse = note, refuse
        actions["change_role"].triggered.connect(lambda _=False: self._change())

    def _change(self) -> None:
        project, selected = self._document.project, self._scene.selected
        if project is None or selected is None or not self._scene.selected_points:
            self._note(NOTHING_SELECTED)
            return
        name = selected[0]
        try:
            edited = edits.with_other_role(project, name)
        except LispacError as error:
            self._refuse(error)
            return
        self._document.edit(f"change of role of {name}", edited)
        word = "a validation plane" if edited.target(name).role == "validation" else "a target"
        self._note(f"{name} is {word} now")
