"""Patch test in the window: objects, angles, and the pictures that follow them."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer

from lispac.errors import LispacError
from lispac.gui import theme, units
from lispac.gui.panels.patch_angles import NEAR
from lispac.gui.panels.patch_test import EMPTY, NO_DATA, PatchTestPanel
from lispac.gui.patch_objects import PatchObjects
from lispac.gui.tasks import Task
from lispac.gui.viewport.base import Array, Colour, Sketch
from lispac.gui.viewport.clipping import EDGES
from lispac.gui.viewport.clipping import Box as ClipBox
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.patchtest.answer import PatchTest
from lispac.patchtest.boxes import Box, PatchObject
from lispac.patchtest.mismatch import Mismatch, lowest
from lispac.patchtest.optimise import Minimum
from lispac.patchtest.pairs import LinePair
from lispac.patchtest.sample import Sample
from lispac.progress import Progress
from lispac.project import Project
from lispac.workflow.opinions import of_the_patch_test
from lispac.workflow.patch_test import PlacedObjects, find, find_angle, line_pairs
from lispac.workflow.survey import Survey

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow

SKETCH = "patch"
ANGLE_NAMES = (N_("roll"), N_("pitch"), N_("yaw"))
COLOUR: Colour = (0, 150, 90)
DENSE = 3_000
"""Points of a line in the picture."""
REACH, INNER = np.radians(0.25), 0.8
"""The curve reaches so far to either side, radians; out of that share of it another is drawn."""
STEPS = {"one": 41, "all": 17}
"""Values of a curve: of one object, and of all."""
WIDE = 12
"""The curve is drawn so many times as wide where it has no minimum within its reach."""
REST_MS = 200
"""After the last move of a slider, before a curve is worked out."""


class PatchTestController(QObject):
    """Keeps the objects, and the pictures in step with the angles."""

    def __init__(self, window: "MainWindow", bring: Callable[[QObject], None]) -> None:
        super().__init__(window)
        self._document, self._runner, self._scene = window.document, window.runner, window.scene
        self._viewport, self._controller = window.viewport, window.controller
        self._actions, self._bring = window.actions_, bring
        self._window = window
        self.panel = PatchTestPanel()
        self._laid: PlacedObjects | None = None
        self._answer: PatchTest | None = None
        self._survey: Survey | None = None
        self._dense: Sample | None = None
        self._taking: Task | None = None
        self._live: Mismatch | None = None
        self._angle = 0
        self._curve_at: Array | None = None
        self._drawn = self._stale = False
        self._rest = QTimer(self, singleShot=True, interval=REST_MS)
        self._rest.timeout.connect(self._ask_curve)
        panel = self.panel
        window.actions_["patch_test"].triggered.connect(lambda _=False: self.open())
        panel.remove_asked.connect(self._remove)
        panel.go_asked.connect(self._go)
        panel.shown_changed.connect(self._show_object)
        panel.ticked_changed.connect(self._ticked)
        panel.all_asked.connect(self.find_all)
        panel.keep_asked.connect(self.keep)
        panel.prior_asked.connect(self._to_prior)
        panel.angles.turned.connect(self._turned)
        panel.angles.find_asked.connect(self.find_angle)
        panel.curve.chosen.connect(self._choose)
        self._document.survey_changed.connect(self._begin)
        self._runner.changed.connect(self._enable)
        self._runner.idle.connect(self._when_idle)
        adding = PatchObjects(window, self.panel, lambda: self._laid)
        adding.laid.connect(self._take)
        self._begin()

    def open(self) -> None:
        """Bring the panel to the front."""
        self._bring(self.panel)

    # -- objects -----------------------------------------------------------------------------

    def _remove(self, name: str) -> None:
        if self._laid is not None and name:
            left = [each.name for each in self._laid.objects if each.name != name]
            self._take(self._laid.only(left) if left else None)

    def _take(self, laid: PlacedObjects | None, shown: str = "") -> None:
        panel = self.panel
        unticked = {n for n in self._names() if n not in panel.ticked}
        self._laid = laid
        panel.show_objects(self._names(), unticked, shown or panel.shown)
        self._forget_answer()
        self._show_object()
        self._enable()

    def _names(self) -> list[str]:
        return [] if self._laid is None else [each.name for each in self._laid.objects]

    def _go(self, name: str) -> None:
        each = self._object(name)
        if each is not None:
            self._viewport.fit(_clip(each.box).corners)

    def _object(self, name: str) -> PatchObject | None:
        objects = () if self._laid is None else self._laid.objects
        return next((each for each in objects if each.name == name), None)

    # -- what follows the angles -------------------------------------------------------------

    def _show_object(self) -> None:
        """Another object is examined, or otherwise."""
        each, survey = self._object(self.panel.shown), self._survey
        if each is None or survey is None or self._laid is None:
            self._dense = self._live = None
            self.panel.picture.show_points({}, {}, np.ones(2))
            self._draw(None)
            return
        corners = _clip(each.box).corners
        self._draw(Sketch(tuple((float(x), float(y), float(z)) for x, y, z in corners), EDGES,
                          COLOUR, label=each.name, at=tuple(each.box.centre.tolist())))  # fmt: skip
        one = self._laid.sample.of_objects([each.name])
        self._live = Mismatch(one, PlacedObjects((each,), (self._laid.boresight,), one).blocks(
            [each.name], self._pairs()))  # fmt: skip
        self._curve_at = None
        self.panel.curve.show_curve("", np.empty(0), np.empty(0))
        if self._dense is None or self._dense.seen[0].object is not each:
            self._dense = None
            self._take_dense(each, self._laid, survey)
        self._follow()

    def _take_dense(self, each: PatchObject, laid: PlacedObjects, survey: Survey) -> None:
        """Take the points that are drawn; until they are there the picture stays as it is."""

        def work(_progress: Progress) -> Sample:
            return Sample.of([each], placed_at(laid, survey), survey.scans, most=DENSE)

        def done(dense: Sample) -> None:
            if self._object(self.panel.shown) is each:
                self._dense = dense
                self._follow()

        title = gettext("Extracting the points of {name}", name=each.name)
        self._taking = self._runner.run(title, work, done, quiet=True, key="patching")

    def _when_idle(self) -> None:
        if self._dense is None and self._taking is not None and self._taking.gave_way:
            self._show_object()
        if self._stale:
            self._rest.start()

    def _turned(self, angle: int) -> None:
        self._angle = angle
        self._follow()

    def _choose(self, value: float) -> None:
        boresight = self.panel.angles.boresight
        boresight[self._angle] = value
        self.panel.angles.turn_to(boresight)
        self._follow()

    def _follow(self) -> None:
        """Draw the lines with the angles as they are now; the curve follows when they rest."""
        each = self._object(self.panel.shown)
        if each is None or self._dense is None or self._survey is None or self._live is None:
            return
        boresight = self.panel.angles.boresight
        across, up, size = _sides(each.box, self.panel.view.currentIndex())
        placed = self._dense.placed(boresight) - each.box.centre
        points = {
            seen.line: placed[seen.points] @ np.column_stack([across, up])
            for seen in self._dense.seen
        }
        colours = theme.line_colours(self._survey.lines)
        self.panel.picture.show_points(points, colours, size)
        curve, value = self.panel.curve, float(boresight[self._angle])
        mismatch = float("nan")
        if self.panel.of.currentIndex() == 0:
            mismatch = self._live(boresight) if self._live.blocks else float("nan")
        curve.show_present(value, mismatch)
        if not self._curve_serves(boresight):
            self._stale = True
            self._rest.start()

    def _curve_serves(self, boresight: Array) -> bool:
        at = self._curve_at
        if at is None:
            return False
        others = [k for k in range(3) if k != self._angle]
        moved = abs(boresight[self._angle] - at[self._angle])
        return bool(self._curve_angle == self._angle and (boresight[others] == at[others]).all()
                    and moved <= INNER * REACH)  # fmt: skip

    def _ask_curve(self) -> None:
        laid, angle, each = self._laid, self._angle, self._object(self.panel.shown)
        if laid is None or each is None or self._runner.busy:
            return
        whole = self.panel.of.currentIndex() == 1
        names = self.panel.ticked if whole else (each.name,)
        boresight, pairs = self.panel.angles.boresight, self._pairs()
        steps = STEPS["all" if whole else "one"]

        def work(progress: Progress) -> tuple[Array, Array]:
            mismatch = Mismatch(laid.sample, laid.blocks(names, pairs))
            for reach, many in ((REACH, steps), (WIDE * REACH, 3 * steps)):
                values = boresight[angle] + np.linspace(-reach, reach, many)
                if not mismatch.blocks:
                    return values, np.full(many, np.nan)
                found = np.empty(many)
                for k, value in enumerate(values):
                    progress(k / many)
                    found[k] = mismatch.curve(boresight, angle, np.array([value]))[0]
                if lowest(values, found) is not None:
                    break
            return values, found

        def done(curve: tuple[Array, Array]) -> None:
            self._stale = False
            self._curve_at, self._curve_angle = boresight, angle
            name = gettext(ANGLE_NAMES[angle])
            if whole:
                title = gettext("Mismatch as a function of {angle}: ticked objects", angle=name)
            else:
                title = gettext(
                    "Mismatch as a function of {angle}: {object}", angle=name, object=each.name
                )
            self.panel.curve.show_curve(title, *curve)
            if not self._curve_serves(self.panel.angles.boresight):
                self._rest.start()

        self._runner.run(gettext("Computing the curve"), work, done, quiet=True, key="patch_curve")

    # -- searching ---------------------------------------------------------------------------

    def find_angle(self, angle: int) -> None:
        """Turn one angle alone to its minimum."""
        laid = self._laid
        if laid is None:
            return
        names, pairs, start = self.panel.ticked, self._pairs(), self.panel.angles.boresight

        def done(found: Minimum) -> None:
            self._angle = angle
            self.panel.angles.start_at(found.boresight, NEAR)
            degrees = float(np.degrees(found.boresight[angle]))
            self.panel.said.setText(
                gettext(
                    "The mismatch is smallest at {angle} {value}, with the other angles unchanged.",
                    angle=gettext(ANGLE_NAMES[angle]),
                    value=units.local_amount(degrees, "°", "+.4f"),
                )
            )
            self._follow()

        self._runner.run(
            gettext("Optimising {angle}", angle=gettext(ANGLE_NAMES[angle])),
            lambda progress: find_angle(
                laid, laid.blocks(names, pairs), start, angle, progress=progress
            ),
            done,
        )

    def find_all(self) -> None:
        """Estimate all three angles and their sigmas."""
        project, survey = self._ready()
        if project is None or survey is None or self._laid is None:
            return
        laid, pairs = self._laid.only(self.panel.ticked), self._pairs()

        def work(progress: Progress) -> PatchTest:
            start = survey.aligned.mounting.boresight
            return find(project, survey, laid, pairs=pairs, start=start, progress=progress)

        def done(found: PatchTest) -> None:
            self._answer = found
            panel = self.panel
            panel.angles.start_at(found.boresight, NEAR)
            panel.angles.show_found(found.boresight, found.sigma, found.curvature)
            panel.said.setText(units.signs("\n".join(map(message_text, found.remarks)), "°", "mm"))
            panel.mark_objects({each.name: each.disagreement for each in found.disagreeing})
            self._follow()
            self._enable()

        task = self._runner.run(gettext("Patch test"), work, done)
        self._controller.based_on_project(task)

    def keep(self) -> None:
        """Keep what was found beside the other methods' answers: one undo step."""
        project = self._document.project
        if project is None or self._answer is None:
            return
        try:
            opinion = of_the_patch_test(self._answer)
        except LispacError as error:
            self._controller.refused.emit(error)
            return
        self._document.edit(N_("result of the patch test"), project.with_opinion(opinion))
        self._controller.noted.emit(
            gettext("The result of the patch test was added to the project.")
        )

    def _to_prior(self) -> None:
        survey = self._survey
        if survey is not None:
            prior = next(iter(survey.clouds.values())).place.mounting.boresight
            self.panel.angles.start_at(prior)
            self._follow()

    # -- state -------------------------------------------------------------------------------

    @property
    def answer(self) -> PatchTest | None:
        """What was found last."""
        return self._answer

    @property
    def waits(self) -> bool:
        """Whether the curve is not yet that of the angles as they are."""
        return self._stale

    def _pairs(self) -> tuple[LinePair, ...]:
        if self._survey is None:
            return ()
        wanted = self.panel.ticked_pairs
        return tuple(pair for pair in line_pairs(self._survey) if pair.name in wanted)

    def _ticked(self) -> None:
        self._forget_answer()
        self._show_object()
        self._enable()

    def _forget_answer(self) -> None:
        """What was found rests on other objects or pairs."""
        self._answer = None
        self.panel.angles.show_found(None)
        self.panel.said.setText("")
        self.panel.mark_objects({})

    def _begin(self) -> None:
        """Other data: nothing is laid."""
        _, survey = self._ready()
        if survey is not None and survey is self._survey:
            return
        self._survey, self._laid, self._answer = survey, None, None
        self._dense = self._live = self._curve_at = None
        self._stale = False
        many = survey is not None and len(survey.clouds) > 1
        self.panel.say_empty(EMPTY if many else NO_DATA)
        self.panel.show_pairs(line_pairs(survey) if survey is not None else ())
        self.panel.curve.show_curve("", np.empty(0), np.empty(0))
        self._forget_answer()
        self._draw(None)
        self._to_prior()
        self._enable()

    def _ready(self) -> tuple[Project | None, Survey | None]:
        current = self._document.survey_is_current
        return self._document.project, self._document.survey if current else None

    def _enable(self) -> None:
        survey = self._survey
        self.panel.allow(
            ready=survey is not None and len(survey.clouds) > 1,
            busy=self._runner.busy,
            answer=self._answer is not None,
        )

    def _draw(self, sketch: Sketch | None) -> None:
        if sketch is not None or self._drawn:
            self._drawn = sketch is not None
            self._viewport.show_sketch(SKETCH, sketch)


def placed_at(laid: PlacedObjects, survey: Survey):
    """The lines as they were placed when the objects were laid, else as the prior places them."""
    from lispac.survey.cloud import placed_with

    if not np.isfinite(laid.boresight).all():
        return survey.clouds
    mounting = next(iter(survey.clouds.values())).place.mounting
    return placed_with(survey.clouds, mounting.with_boresight(laid.boresight))


def _clip(box: Box) -> ClipBox:
    return ClipBox(box.centre, box.axes, 0.5 * box.size)


def _sides(box: Box, view: int) -> tuple[Array, Array, Array]:
    """Axes to the right and upwards of a picture, and its size with a margin, metres."""
    ahead, left, up = box.axes
    room = 0.3
    if view == 0:
        return -left, ahead, box.size[[1, 0]] + room
    if view == 1:
        return -left, up, box.size[[1, 2]] + room
    return ahead, up, box.size[[0, 2]] + room
