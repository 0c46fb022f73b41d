"""The three-minute tour: a guided calibration of the demo survey.

The user does each step with the ordinary functions of the window. The tour shows the instruction,
moves the view to the target, and continues when the state of the project shows that the step is
done.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QVBoxLayout

from lispac.acceptance import Verdict
from lispac.gui import widgets
from lispac.gui.app.point_colours import Colouring
from lispac.gui.appearance import theme
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.project.status import TARGETS
from lispac.gui.viewport.base import Sketch, Viewport
from lispac.gui.widgets.reserved_label import ReservedLabel
from lispac.language import N_, gettext
from lispac.project import Project
from lispac.workflow.calibration.orientation_check import have_targets_single_orientation
from lispac.workflow.planning.demo import demo_seeds

VIEW_RADIUS_M = 2.5
"""Half width and half height of the area around a board that is brought into view, metres."""


@dataclass(frozen=True)
class TourStep:
    """One step of the tour: its instruction, its target and the test whether it is done.

    Attributes
    ----------
    text : instruction, marked with `N_`
    place : name of a seed of the demo that is brought into view; "" for the whole survey
    colouring : "intensity" where a board is to be clicked, which is brighter than the wall
    done : function of the project, and of whether a detected plane is not yet accepted, that
        returns whether the step is done
    """

    text: str
    place: str
    done: Callable[[Project, bool], bool]
    colouring: Colouring = "line"


def _target_count(project: Project, role: str) -> int:
    return len(project.targets_of_role(role))


VERDICT_TEXTS: Mapping[Verdict, str] = {
    "pass": N_("The calibration meets the acceptance criteria. Press Ctrl+E to write the report."),
    "fail": N_(
        "The calibration does not meet the acceptance criteria; step 4 on the left gives the "
        "reasons. Ctrl+E writes the report, with this verdict."
    ),
    "not judged": N_(
        "The histograms show the distances between the lines, and B switches the view between "
        "before and after. Enter the criteria of your contract in step 4, then press Ctrl+E for "
        "the report."
    ),
}
"""Instruction of the last step, by the verdict on the calibration."""

TOUR_STEPS = (
    TourStep(N_("Six lines along a quay do not agree, because the boresight is not calibrated. "
            "Hold Ctrl and click the bright board in the frame."), "T1",
         lambda project, candidate_waits: candidate_waits or _target_count(project, "target") >= 1,
         "intensity"),
    TourStep(N_("The plane of the board was found in every line. Press Enter to accept it."), "T1",
         lambda project, _candidate_waits: _target_count(project, "target") >= 1, "intensity"),
    TourStep(N_("One board does not determine all three angles. Ctrl+click the framed board, "
            "which leans back, and press Enter."), "T2",
         lambda project, _candidate_waits: _target_count(project, "target") >= 2, "intensity"),
    TourStep(N_("Press F9 to estimate the boresight. Roll, pitch and yaw appear below the view, "
            "with their standard deviations."), "",
         lambda project, _candidate_waits: project.result is not None),
    TourStep(N_("Now compare the lines on a plane that is not used in the adjustment. Press F7, "
            "Ctrl+click in the frame and press Enter."), "V1",
         lambda project, _candidate_waits: _target_count(project, "validation") >= 1),
    TourStep(N_("Press F10 to compare the lines on this plane before and after the "
            "calibration."), "",
         lambda project, _candidate_waits: bool(project.validation)),
    TourStep(VERDICT_TEXTS["not judged"], "", lambda _project, _candidate_waits: False),
)  # fmt: skip


FRAME_SIZE_M = 1.8
"""Width of the frame around the place to click, and its height unless given below, metres."""
FRAME_HEIGHTS_M = {"T2": 1.2}
"""Heights of the frames around low surfaces, metres: beside the surface is another one."""
SKETCH_NAME = "tour"

SAME_ORIENTATION_TEXT = N_(
    "This target has the same orientation as the other, so the angles are not determined. Undo "
    "with Ctrl+Z, then Ctrl+click the board that leans back and press Enter."
)
"""Instruction shown instead of that of the step while all targets have the same orientation."""


EXPORTED_TEXT = N_(
    "The report is written, and the tour is complete. To calibrate your own survey, choose New "
    "project in the menu File."
)
"""Instruction after the export of the report."""

ALL_TEXTS = (
    *(step.text for step in TOUR_STEPS), *VERDICT_TEXTS.values(), SAME_ORIENTATION_TEXT,
    EXPORTED_TEXT,
)  # fmt: skip
"""All instructions."""


class TourCard(QFrame):
    """Card with the instruction of the current step, above the view."""

    ended = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("tour_card")
        self.setProperty("role", "candidate")
        layout = QHBoxLayout(self)
        layout.setContentsMargins(14, 8, 10, 8)
        texts = QVBoxLayout()
        self.head = widgets.label("", "heading", name="tour_head")
        # The view below does not move from step to step
        self.text = ReservedLabel(name="tour_text", texts=[gettext(each) for each in ALL_TEXTS])
        texts.addWidget(self.head)
        texts.addWidget(self.text)
        layout.addLayout(texts, 1)
        self.end = widgets.button(gettext("End the tour"), "tour_end")
        self.end.clicked.connect(self.ended)
        layout.addWidget(self.end)
        self.hide()

    def show_step(self, number: int, text: str) -> None:
        """Show an instruction, marked with `N_`; ``number`` counts from 0."""
        head = gettext("Tour, step {step:n} of {count:n}", step=number + 1, count=len(TOUR_STEPS))
        self.head.setText(head)
        self.text.setText(gettext(text))
        last = number == len(TOUR_STEPS) - 1
        self.end.setText(gettext("Close") if last else gettext("End the tour"))
        self.show()


class Tour(QObject):
    """Guides the user through the steps of the tour."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        viewport: Viewport,
        controller: Controller,
        card: TourCard,
        may_leave: Callable[[], bool],
        may_remove_targets: Callable[[int], bool],
        open_step: Callable[[int], None],
        colour_by: Callable[[Colouring], None],
    ) -> None:
        super().__init__(controller)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._controller, self._card = controller, card
        self._may_leave, self._may_remove_targets = may_leave, may_remove_targets
        self._open_step, self._colour_by = open_step, colour_by
        self._colouring: Colouring | None = None
        """Colouring that the tour has chosen last."""
        self._step_index: int | None = None
        self._text = ""
        self._starting = False
        self._place: str | None = None
        """`TourStep.place` to bring into view when the lines are drawn; None if there is none."""
        card.ended.connect(self.end)
        document.opened.connect(self._on_project_opened)
        document.changed.connect(self._show_current_step)
        controller.candidate_changed.connect(self._show_current_step)
        scene.drawn.connect(self._view_place)

    @property
    def is_running(self) -> bool:
        """Whether the tour is running."""
        return self._step_index is not None

    def start(self) -> None:
        """Open the demo without its targets and start the tour."""
        if self._may_leave():
            self._controller.open_demo(first=self._mark_start)

    def _mark_start(self) -> None:
        # Set only when the demo is opened: if it is cancelled, the next project keeps its targets
        self._starting = True

    def resume(self) -> None:
        """Show the first step that is not done, at the start and in a rebuilt window."""
        self._step_index = -1
        self._show_current_step()

    def end(self) -> None:
        """End the tour, with the usual colours."""
        if self._colouring == "intensity":
            self._colour_by("line")
        self._step_index = self._place = self._colouring = None
        self._card.hide()
        self._viewport.show_sketch(SKETCH_NAME, None)

    def _on_project_opened(self) -> None:
        starting, self._starting = self._starting, False
        if not starting:
            self.end()
            return
        project = self._document.project
        assert project is not None
        if project.targets:  # of an earlier tour
            if not self._may_remove_targets(len(project.targets)):
                self.end()
                return
            for target in project.targets:
                project = project.without_target(target.name)
            self._document.edit(N_("start of the tour"), project)
        self._open_step(TARGETS)
        self.resume()

    def _show_current_step(self) -> None:
        project = self._document.project
        if self._step_index is None or project is None:
            return
        candidate_waits = self._controller.candidate is not None
        at = next(k for k, step in enumerate(TOUR_STEPS) if not step.done(project, candidate_waits))
        document, text = self._document, TOUR_STEPS[at].text
        if project.result is None and document.is_survey_current:
            assert document.survey is not None
            text = (
                SAME_ORIENTATION_TEXT
                if have_targets_single_orientation(project, document.survey)
                else text
            )
        if at == len(TOUR_STEPS) - 1:
            text = VERDICT_TEXTS[project.judgement.verdict]
            if document.report is not None and document.report.is_current:
                text = EXPORTED_TEXT
        if (at, text) != (self._step_index, self._text):
            self._step_index, self._text = at, text
            self._card.show_step(at, text)
            self._place = TOUR_STEPS[at].place
            if not self._scene.awaits_lines:
                self._view_place()

    def _view_place(self) -> None:
        place, self._place = self._place, None
        if place is None:
            return
        self._choose_colouring()
        self._viewport.show_sketch(SKETCH_NAME, _frame_around(place) if place else None)
        if place:
            centre = np.array(demo_seeds()[place][1])
            corners = centre + VIEW_RADIUS_M * np.array([[-1.0, 0.0, -1.0], [1.0, 0.0, 1.0]])
            self._viewport.view_along(np.array([0.0, 1.0, 0.0]), corners)
        else:
            self._viewport.fit()

    def _choose_colouring(self) -> None:
        """Colour the points for the step; a choice of the user is kept during similar steps."""
        assert self._step_index is not None
        colouring = TOUR_STEPS[self._step_index].colouring
        if colouring != self._colouring:
            self._colouring = colouring
            self._colour_by(colouring)


def _frame_around(place: str) -> Sketch:
    """Frame around the place to click, seen from the south or north."""
    x, y, z = demo_seeds()[place][1]
    half, half_height = FRAME_SIZE_M / 2, FRAME_HEIGHTS_M.get(place, FRAME_SIZE_M) / 2
    corners = tuple(
        (x + dx * half, y, z + dz * half_height) for dx, dz in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    )
    return Sketch(corners, ((0, 1), (1, 2), (2, 3), (3, 0)), theme.CANDIDATE_COLOUR)
