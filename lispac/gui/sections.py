"""Section through the selected target, or between two clicked points."""

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QObject

from lispac.errors import LispacError
from lispac.gui import theme
from lispac.gui.actions import Actions
from lispac.gui.document import Document
from lispac.gui.mouse_tool import MouseTool
from lispac.gui.panels.histograms import preload
from lispac.gui.panels.section import EMPTY, SectionPanel
from lispac.gui.scene import Scene
from lispac.gui.tasks import TaskRunner
from lispac.gui.viewport.base import Array, Colour, PickedPoint, Sketch, Viewport
from lispac.gui.viewport.clipping import EDGES, Box
from lispac.language import N_, gettext
from lispac.progress import Progress
from lispac.targets.section import Section
from lispac.workflow.sections import Cut, cut_between, cut_target

SKETCH = "section"
COLOUR: Colour = (0, 90, 200)
HINTS = (N_("Click the start of the section"), N_("Click the end of the section"))


class Sections(QObject):
    """Cuts the section in the background, while its panel is visible."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        actions: Actions,
        mouse_tool: MouseTool,
        bring: Callable[[QObject], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._scene = document, runner, scene
        self._viewport, self._mouse_tool, self._bring = viewport, mouse_tool, bring
        self.panel = SectionPanel()
        self._ends: list[Array] = []
        self._stale = self._seen = self._drawn = False
        self._shown: tuple[tuple[object, ...], tuple[object, ...]] | None = None
        self._cuts: Sequence[Cut] = ()
        self.panel.changed.connect(self._update)
        self.panel.points_asked.connect(actions["section_points"].trigger)
        actions["section"].triggered.connect(lambda _=False: self._open())
        actions["section_points"].triggered.connect(self._switch)
        scene.selection_changed.connect(self._another)
        document.opened.connect(self._another)
        document.changed.connect(self._update)
        scene.which_changed.connect(lambda _which: self._update())
        runner.idle.connect(lambda: self._stale and self._update())

    def _open(self) -> None:
        self._bring(self.panel)

    def be_seen(self, seen: bool) -> None:
        """The panel is in front of the others, or not."""
        self._seen = seen
        self._update()

    # -- between two points ------------------------------------------------------------------

    def _switch(self, on: bool) -> None:
        if not on:
            self._mouse_tool.end()
            return
        self._ends = []
        self._draw(None)
        hint = gettext(HINTS[0])
        self._mouse_tool.begin("section_points", hint, pointed=self._take, ended=self._give_up)

    def _take(self, point: PickedPoint) -> None:
        self._ends.append(np.array(point.position))
        if len(self._ends) == 1:
            self._mouse_tool.hint(gettext(HINTS[1]))
            self._draw(Sketch((point.position,), (), COLOUR, dots=True))
            return
        self._mouse_tool.end()
        self._open()
        self._update()

    def _give_up(self) -> None:
        if len(self._ends) < 2:
            self._ends = []
            self._draw(None)

    # -- cutting -----------------------------------------------------------------------------

    def _another(self) -> None:
        """A target was selected: it is cut, and no longer what lies between two points."""
        self._ends = []
        self._update()

    def _update(self) -> None:
        project, survey = self._document.project, self._document.survey
        panel, selected = self.panel, self._scene.selected
        if not self._seen:
            self._draw(None)
            return
        ends = tuple(self._ends) if len(self._ends) == 2 else None
        known = project is not None and {target.name for target in project.targets}
        name = selected[0] if selected is not None and known and selected[0] in known else None
        ready = survey is not None and self._document.survey_is_current
        if project is None or survey is None or not ready or not (ends or name):
            self._show_nothing(gettext(EMPTY))
            return
        level, size, thickness = panel.level, panel.size.value(), panel.thickness.value()
        target = project.target(name) if name else None
        rests_on = (project.result, target, survey, *(ends or ()))
        asked = (level, size, thickness, *map(id, rests_on))
        if not self._stale and self._shown is not None and asked == self._shown[0]:
            self._sketch()
            return
        self._stale = True

        def work(progress: Progress) -> Sequence[Cut] | str:
            preload()
            try:
                if ends is not None:
                    return cut_between(
                        project, survey, *ends, height=size, thickness=thickness,
                        progress=progress,
                    )  # fmt: skip
                return cut_target(
                    project, survey, name, level=level, size=size, thickness=thickness,
                    progress=progress,
                )  # fmt: skip
            except LispacError as error:
                return str(error)

        def done(cuts: Sequence[Cut] | str) -> None:
            self._stale = False
            self._shown = asked, rests_on  # kept, so that no other object gets their id
            if isinstance(cuts, str):
                self._show_nothing(cuts)
                return
            self._cuts = cuts
            if ends is not None:
                through = gettext("Between two points")
            else:
                through = gettext("Across {target}", target=name)
            panel.show_cuts(
                through, cuts, theme.line_colours(survey.lines), target=ends is None
            )  # fmt: skip
            self._sketch()

        title = gettext("Cutting the section")
        self._runner.run(title, work, done, quiet=True, key="section")

    def _show_nothing(self, text: str) -> None:
        self._stale, self._shown = False, None
        self.panel.show_nothing(text)
        self._draw(None)

    def _sketch(self) -> None:
        """Draw the frame of what is cut into the view."""
        cut = next((c for c in self._cuts if c.which == self._scene.which), self._cuts[0])
        self._draw(frame_of(cut.section))

    def _draw(self, sketch: Sketch | None) -> None:
        if sketch is not None or self._drawn:
            self._drawn = sketch is not None
            self._viewport.show_sketch(SKETCH, sketch)


def frame_of(section: Section) -> Sketch:
    """The strip's box."""
    half = 0.5 * np.array([section.width, section.height, section.thickness])
    box = Box(section.centre, np.array([section.right, section.up, section.across]), half)
    places = tuple((float(x), float(y), float(z)) for x, y, z in box.corners)
    return Sketch(places, EDGES, COLOUR)
