"""Section through the selected target, or between two clicked points."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.tasks import TaskRunner, preload_matplotlib
from lispac.gui.appearance import theme
from lispac.gui.features.inspect.linked_views import section_box
from lispac.gui.features.inspect.section_panel import EMPTY_TEXT, SectionPanel
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import (
    Array,
    DragHandle,
    PickedPoint,
    Sketch,
    Viewport,
)
from lispac.gui.viewport.clipping import BOX_EDGES
from lispac.gui.widgets.error_box import exception_text
from lispac.language import N_, gettext
from lispac.present.checking.validation import PairOffset, ValidationPlane
from lispac.progress import Progress
from lispac.project import BoresightChoice, Project
from lispac.targets.cross_section import Section
from lispac.workflow.checking.survey_sections import (
    SectionPoints,
    cut_between_points,
    section_at_target,
)

SKETCH_NAME = "section"
DRAG_UPDATE_MS = 150
"""Time between two updates of the picture while the section is dragged."""
MIN_LENGTH_M = 0.1
"""Smallest length of a section between two points, metres, to which its ends can be dragged."""
MIDDLE, FIRST_END, SECOND_END = range(3)
"""Handles of a section; those at the ends are for sections between two points."""
HINTS = (N_("Click the start of the section"), N_("Click the end of the section"))


class SectionTool(QObject):
    """Computes the section in the background while its panel is visible."""

    moved = Signal()
    """Another section is shown in the view, or none."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        actions: Actions,
        mouse_tool: MouseTool,
        bring: Callable[[QObject], None],
        is_linked: Callable[[], bool],
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._scene = document, runner, scene
        self._viewport, self._mouse_tool, self._bring = viewport, mouse_tool, bring
        self._is_linked = is_linked
        self.panel = SectionPanel()
        self._ends: list[Array] = []
        self._clicked = 0
        """Number of sections between two points that were begun."""
        self._subject: str | int | None = None
        """Target, or number of the two points, of the picture."""
        self._outdated = self._panel_visible = self._drawn = False
        self._shown: tuple[tuple[object, ...], tuple[object, ...]] | None = None
        self._cuts: Sequence[SectionPoints] = ()
        self._framed: Section | None = None
        self._offset = 0.0  # of a section across a target, metres along its thickness
        self._is_dragged = False
        self._drag_update = QTimer(self, singleShot=True, interval=DRAG_UPDATE_MS)
        self._drag_update.timeout.connect(self._update_section)
        viewport.signals.handle_moved.connect(self._drag)
        viewport.signals.handle_released.connect(self._on_released)
        for name, direction in (("section_forward", 1.0), ("section_backward", -1.0)):
            actions[name].triggered.connect(lambda _on, sign=direction: self._step(sign))
        self.panel.changed.connect(self._update_section)
        self.panel.points_requested.connect(actions["section_points"].trigger)
        actions["section"].triggered.connect(lambda _=False: self._open())
        actions["section_points"].triggered.connect(self._toggle_tool)
        scene.selection_changed.connect(self._cut_target)
        document.opened.connect(self._cut_target)
        document.changed.connect(self._update_section)
        scene.which_changed.connect(lambda _which: self._update_section())
        runner.idle.connect(lambda: self._outdated and self._update_section())

    def _open(self) -> None:
        self._bring(self.panel)

    def set_panel_visible(self, visible: bool) -> None:
        """Set whether the panel is visible."""
        self._panel_visible = visible
        self._update_section()

    def copy_state_from(self, former: "SectionTool") -> None:
        """Take over the ends of the section of a former window."""
        self._ends, self._offset = list(former._ends), former._offset
        if len(self._ends) == 1:
            self._show_first_end()
        self._update_section()

    # -- between two points ------------------------------------------------------------------

    def _toggle_tool(self, on: bool) -> None:
        if not on:
            self._mouse_tool.end()
            return
        self._ends = []
        self._clicked += 1
        self._draw_sketch(None)
        hint = gettext(HINTS[0])
        self._mouse_tool.begin(
            "section_points", hint, pointed=self._add_point, ended=self._discard_points
        )

    def _add_point(self, point: PickedPoint) -> None:
        self._ends.append(np.array(point.position))
        if len(self._ends) == 1:
            self._show_first_end()
            return
        self._mouse_tool.end()
        self._open()
        self._update_section()

    def _show_first_end(self) -> None:
        north, west, up = (float(v) for v in self._ends[0])
        self._mouse_tool.hint(gettext(HINTS[1]))
        self._draw_sketch(Sketch(((north, west, up),), (), theme.rgb("accent"), dots=True))

    def _discard_points(self) -> None:
        if len(self._ends) < 2:
            self._ends = []
            self._draw_sketch(None)

    # -- section -----------------------------------------------------------------------------

    def _cut_target(self) -> None:
        """Cut the newly selected target instead of a section between two points."""
        self._ends, self._offset = [], 0.0
        self._update_section()

    def _update_section(self) -> None:
        project, survey = self._document.project, self._document.survey
        panel, selected = self.panel, self._scene.selected
        # Linked views keep the section when another panel opens in front of this one.
        if not self._panel_visible and not (self._is_linked() and self._framed is not None):
            self._draw_sketch(None)
            return
        ends = tuple(self._ends) if len(self._ends) == 2 else None
        known = project is not None and {target.name for target in project.targets}
        name = selected[0] if selected is not None and known and selected[0] in known else None
        ready = survey is not None and self._document.is_survey_current
        if project is None or survey is None or not ready or not (ends or name):
            self._show_nothing(gettext(EMPTY_TEXT))
            return
        level, size, thickness = panel.is_horizontal, panel.size.value(), panel.thickness.value()
        target, offset = project.target(name) if name else None, self._offset
        offsets = {} if ends or name is None else _largest_offsets(project, name)
        inputs = (project.result, project.validation, target, survey, *(ends or ()))
        requested = (level, size, thickness, offset, *map(id, inputs))
        if not self._outdated and self._shown is not None and requested == self._shown[0]:
            self._draw_frame()
            return
        self._outdated = True
        subject = name if ends is None else self._clicked
        if subject != self._subject:
            panel.show_nothing(gettext("Computing the section"))
        self._subject = subject

        def work(progress: Progress) -> Sequence[SectionPoints] | str:
            preload_matplotlib()
            try:
                if ends is not None:
                    return cut_between_points(
                        project, survey, *ends, height=size, thickness=thickness,
                        progress=progress,
                    )  # fmt: skip
                return section_at_target(
                    project, survey, name, level=level, size=size, thickness=thickness,
                    offset=offset, progress=progress,
                )  # fmt: skip
            except LispacError as error:
                return exception_text(error)

        def done(cuts: Sequence[SectionPoints] | str) -> None:
            self._outdated = False
            self._shown = requested, inputs  # references prevent the reuse of their ids
            if isinstance(cuts, str):
                self._show_nothing(cuts)
                return
            self._cuts = cuts
            if ends is not None:
                through = gettext("Between two points")
            else:
                through = gettext("Across {target}", target=name)
            panel.show_cuts(
                through, cuts, theme.line_colours(survey.lines), offsets, target=ends is None
            )  # fmt: skip
            self._draw_frame()

        title = gettext("Cutting the section")
        self._runner.run(title, work, done, quiet=True, key="section")

    def _show_nothing(self, text: str) -> None:
        self._outdated, self._shown, self._subject = False, None, None
        self.panel.show_nothing(text)
        self._draw_sketch(None)

    @property
    def section(self) -> Section | None:
        """Section whose frame is shown in the view; None if there is none."""
        return self._framed

    def _draw_frame(self) -> None:
        """Draw the frame of the section into the view; while it is dragged, it is ahead of it."""
        if self._is_dragged:
            return
        cut = next((c for c in self._cuts if c.which == self._scene.which), self._cuts[0])
        self._show_frame(cut.section)
        self.moved.emit()

    def _show_frame(self, section: Section) -> None:
        self._framed = section
        self._draw_sketch(section_box_sketch(section, has_ends=len(self._ends) == 2))

    # -- movements ---------------------------------------------------------------------------

    def _step(self, sign: float) -> None:
        """Move the section by its thickness."""
        if self._framed is not None:
            self._move(MIDDLE, sign * self._framed.thickness)
            self._update_section()

    def _drag(self, name: str, handle: int, metres: float) -> None:
        if name == SKETCH_NAME and self._framed is not None:
            self._is_dragged = True
            self._move(handle, metres)
            if not self._drag_update.isActive():
                self._drag_update.start()

    def _on_released(self, name: str) -> None:
        if name == SKETCH_NAME and self._is_dragged:
            self._is_dragged = False
            self._drag_update.stop()
            self._update_section()

    def _move(self, handle: int, metres: float) -> None:
        """Move the section along its thickness, or one of its ends along its length."""
        section = self._framed
        assert section is not None
        centre, width = section.centre, section.width
        if handle == MIDDLE:
            centre = centre + metres * section.across
            if self._ends:
                self._ends = [end + metres * section.across for end in self._ends]
            else:
                self._offset += metres
        else:
            sign = -1.0 if handle == FIRST_END else 1.0
            metres = sign * max(sign * metres, MIN_LENGTH_M - width)
            ends = list(self._ends)
            ends[handle - FIRST_END] = ends[handle - FIRST_END] + metres * section.right
            self._ends = ends
            centre, width = centre + 0.5 * metres * section.right, width + sign * metres
        self._show_frame(replace(section, centre=centre, width=width))

    def _draw_sketch(self, sketch: Sketch | None) -> None:
        if sketch is None and self._framed is not None:
            self._framed = None
            self.moved.emit()
        if sketch is not None or self._drawn:
            self._drawn = sketch is not None
            self._viewport.show_sketch(SKETCH_NAME, sketch)


def _largest_offsets(project: Project, name: str) -> dict[BoresightChoice, PairOffset]:
    """Largest offset of two lines in each picture; the lines before and after may differ."""
    found: dict[BoresightChoice, PairOffset] = {}
    for plane in (ValidationPlane.of(each) for each in project.validation if each.name == name):
        if (before := plane.largest_offset_before) is not None:
            found["prior"] = before
        if (after := plane.largest_offset) is not None:
            found["estimated"] = after
    return found


def section_box_sketch(section: Section, *, has_ends: bool) -> Sketch:
    """Outline of the box that a section cuts out, with handles to move it and its ends."""
    handles = [_handle(section.centre, section.across)]
    if has_ends:
        along = 0.5 * section.width * section.right
        handles += [_handle(section.centre + sign * along, section.right) for sign in (-1.0, 1.0)]
    places = tuple((float(x), float(y), float(z)) for x, y, z in section_box(section).corners)
    return Sketch(places, BOX_EDGES, theme.rgb("accent"), handles=tuple(handles))


def _handle(place: Array, axis: Array) -> DragHandle:
    (a, b, c), (d, e, f) = place.tolist(), axis.tolist()
    return DragHandle((a, b, c), (d, e, f))
