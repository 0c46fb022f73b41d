"""Several linked views beside each other: before and after, from above and a section."""

from collections.abc import Callable, Mapping

import numpy as np
from PySide6.QtCore import QObject
from PySide6.QtGui import QActionGroup

from lispac.gui.app.actions import Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason
from lispac.gui.project.computations import Computations
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, LinkedView, Viewport
from lispac.gui.viewport.clipping import Box
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.language import gettext
from lispac.targets.cross_section import Section

LEFT, RIGHT = (0.0, 0.0, 0.5, 1.0), (0.5, 0.0, 0.5, 1.0)
UPPER_LEFT, UPPER_RIGHT = (0.0, 0.0, 0.5, 0.5), (0.5, 0.0, 0.5, 0.5)
LOWER_LEFT, LOWER_RIGHT = (0.0, 0.5, 0.5, 0.5), (0.5, 0.5, 0.5, 0.5)
UPPER = (0.0, 0.0, 1.0, 0.5)
"""Parts of the viewport: left, top, width and height, shares of its size."""
COUNTS = {"one_view": 1, "two_views": 2, "four_views": 4}
"""Number of views of each action."""
OUTLINE_TOOLS = ("lasso_add", "lasso_remove")
"""Tools that need a single view, since an outline refers to its camera."""


class LinkedViews(QObject):
    """Shows two or four views until one is chosen, Esc is pressed or other lines are chosen.

    Attributes
    ----------
    count : number of views; without a result, two of the four are one wide view
    """

    def __init__(
        self,
        document: Document,
        scene: Scene,
        computations: Computations,
        viewport: Viewport,
        actions: Actions,
        mouse_tool: MouseTool,
        section: Callable[[], Section | None],
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene, self._computations = document, scene, computations
        self._viewport, self._actions, self._mouse_tool = viewport, actions, mouse_tool
        self._section, self._note = section, note
        self.count = 1
        self._due = IdleTask(self._show, self)
        for name, count in COUNTS.items():
            actions[name].triggered.connect(lambda _on, count=count: self.choose(count))
        for name in ("before", "after", "wipe"):
            actions[name].triggered.connect(self._on_lines_chosen)
        scene.drawn.connect(self.update)
        scene.targets_drawn.connect(self.update)
        document.about_to_open.connect(self.end)
        document.changed.connect(self._enable)
        self._enable()

    def choose(self, count: int) -> None:
        """Show one, two or four views; one if the present number is chosen again."""
        if count == 1 or count == self.count:
            self.end()
            return
        if self._mouse_tool.tool in OUTLINE_TOOLS:
            self._mouse_tool.end()
        self.count = count
        chosen = next(name for name, each in COUNTS.items() if each == count)
        self._actions[chosen].setChecked(True)
        self._show_choice()
        self._note(gettext("Linked views: Esc returns to one view."))
        self._mouse_tool.end_mode = self.end
        self._enable()
        if self._has_result and self._scene.which == "prior":
            self._computations.show("estimated")  # `drawn` follows
        else:
            self._show()

    def update(self) -> None:
        """Show the present lines, sightings and section."""
        if self.count > 1:
            self._due.start()

    def end(self) -> None:
        """Show one view."""
        if self.count == 1:
            self._actions["one_view"].setChecked(True)
            return
        self.count = 1
        self._due.stop()
        self._mouse_tool.end_mode = None
        self._actions["one_view"].setChecked(True)
        self._show_choice()
        self._enable()
        self._viewport.show_linked(())

    def _show_choice(self) -> None:
        """Show neither *Before* nor *After* as chosen while both are shown beside each other."""
        group = self._actions["before"].actionGroup()
        policies, chosen = QActionGroup.ExclusionPolicy, group.checkedAction()
        if self.count > 1 and self._has_result:
            group.setExclusionPolicy(policies.ExclusiveOptional)
            if chosen is not None:
                chosen.setChecked(False)
        else:
            group.setExclusionPolicy(policies.Exclusive)
            if chosen is None:
                which = "after" if self._scene.which == "estimated" else "before"
                self._actions[which].setChecked(True)

    @property
    def _has_result(self) -> bool:
        project = self._document.project
        return project is not None and project.result is not None

    def _on_lines_chosen(self) -> None:
        if self._has_result:
            self.end()

    def _show(self) -> None:
        if self._scene.awaits_lines:
            return  # `drawn` follows
        prior_chosen = self._scene.which == "prior" and self._scene.has_estimated
        if (
            self._document.survey is None
            or prior_chosen
            or (self.count == 2 and not self._has_result)
        ):
            self.end()
        elif self._scene.which == "estimated" or self.count == 4:
            self._viewport.show_linked(self._views())

    def _views(self) -> list[LinkedView]:
        before, after = gettext("Before"), gettext("After")
        if self._scene.which == "prior":
            return [LinkedView(before, UPPER), *self._lower_views()]
        samples = _samples(self._scene.clouds_of("prior"))
        prior = self._scene.highlights("prior")
        if self.count == 2:
            return [
                LinkedView(after, RIGHT),
                LinkedView(before, LEFT, clouds=samples, highlights=prior),
            ]
        return [
            LinkedView(after, UPPER_RIGHT),
            LinkedView(before, UPPER_LEFT, clouds=samples, highlights=prior),
            *self._lower_views(),
        ]

    def _lower_views(self) -> list[LinkedView]:
        section = self._section()
        if section is None:
            title, direction, box = gettext("Horizontal view"), "side", None
        else:
            title, direction, box = gettext("Section"), "section", section_box(section)
        shown = gettext("Before") if self._scene.which == "prior" else gettext("After")
        return [
            LinkedView(f"{gettext('Top')} · {shown}", LOWER_LEFT, "top"),
            LinkedView(f"{title} · {shown}", LOWER_RIGHT, direction, box=box),
        ]

    def _enable(self) -> None:
        has_project = self._document.project is not None
        no_project = first_reason((not has_project, Unavailable.NO_PROJECT))
        reasons: dict[str, Reason] = {
            "one_view": no_project,
            "two_views": no_project or first_reason(
                (not self._has_result, Unavailable.NO_RESULT)
            ),
            "four_views": no_project,
            **dict.fromkeys(
                OUTLINE_TOOLS,
                no_project or first_reason((self.count > 1, Unavailable.LINKED_VIEWS)),
            ),
        }  # fmt: skip
        for name, reason in reasons.items():
            self._actions.set_reason(name, reason)


def _samples(clouds: Mapping[str, object]) -> dict[str, Array]:
    return {name: cloud.sample for name, cloud in clouds.items()}


def section_box(section: Section) -> Box:
    """Box that a section cuts out; its third axis is along the thickness."""
    half = 0.5 * np.array([section.width, section.height, section.thickness])
    return Box(section.centre, np.array([section.right, section.up, section.across]), half)
