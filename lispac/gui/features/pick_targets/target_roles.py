"""Change of the role of the selected target or validation plane."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.language import N_, gettext
from lispac.workflow.calibration import edits

NOTHING_SELECTED = N_("Select a target or validation plane first, then change its role.")


class TargetRoles(QObject):
    """Changes a target into a validation plane, or the reverse."""

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
        actions["change_role"].triggered.connect(lambda _=False: self._change_role())

    def _change_role(self) -> None:
        project, selected = self._document.project, self._scene.selected
        if project is None or selected is None or not self._scene.selected_points:
            self._note(gettext(NOTHING_SELECTED))
            return
        name = selected[0]
        try:
            edited = edits.with_switched_role(project, name)
        except LispacError as error:
            self._refuse(error)
            return
        self._document.edit(N_("change of role of {target}"), edited, target=name)
        if edited.target(name).role == "validation":
            self._note(gettext("{target} is now a validation plane.", target=name))
        else:
            self._note(gettext("{target} is now a target.", target=name))
