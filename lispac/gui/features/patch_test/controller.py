"""Controller of the patch test: objects, angles, and the pictures that depend on them."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QTimer

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.app.docks import raise_panel
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.patch_test.angles import RESULT_RANGE_DEG
from lispac.gui.features.patch_test.objects import PatchObjects
from lispac.gui.features.patch_test.panel import EMPTY_TEXT, NO_DATA_TEXT, PatchTestPanel
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, Colour, Sketch, Viewport
from lispac.gui.viewport.clipping import BOX_EDGES
from lispac.gui.viewport.clipping import Box as ClipBox
from lispac.gui.widgets.result_tables import local_amount, local_number
from lispac.language import N_, gettext
from lispac.patchtest.line_mismatch import Mismatch, curve_minimum
from lispac.patchtest.line_pairs import LinePair
from lispac.patchtest.mismatch_minimisation import MismatchMinimum
from lispac.patchtest.object_boxes import ObjectBox, PatchObject
from lispac.patchtest.object_sample import ObjectSample
from lispac.patchtest.patch_test_result import PatchTestResult
from lispac.present.calibration.patch_test import PatchTestValues
from lispac.present.tables import DEGREES, ratio
from lispac.progress import Progress
from lispac.project import Project
from lispac.validation.repeatability import Calibration, compare_calibrations
from lispac.workflow.calibration.method_runs import patch_test_result
from lispac.workflow.calibration.patch_test import (
    PlacedObjects,
    find_angle,
    find_boresight,
    line_pairs,
)
from lispac.workflow.project.survey import Survey

SKETCH_NAME = "patch"
ANGLE_NAMES = (N_("roll"), N_("pitch"), N_("yaw"))
SKETCH_COLOUR: Colour = (0, 150, 90)
MAX_POINTS = 3_000
"""Approximate largest number of points of an object drawn in the picture, for each line."""
CURVE_HALF_WIDTH, CURVE_INNER_SHARE = np.radians(0.25), 0.8
"""Half width of the curve, radians, and the share of it beyond which a new curve is computed."""
CURVE_STEPS = {"one": 41, "all": 17}
"""Number of values of a curve, for one object and for all objects."""
WIDENING_FACTOR = 12
"""Factor by which the curve is widened if it has no clear minimum within its width."""
DEBOUNCE_MS = 200
"""Pause after the last move of a slider before a curve is computed."""
SIGMA_RATIO = ratio(1)
"""Format of a difference in standard deviations."""
DIFFERENCE_TEXTS = {
    False: N_(
        "No significant difference from the adjustment: roll {roll} ({roll_ratio}\u00a0σ), pitch "
        "{pitch} ({pitch_ratio}\u00a0σ), yaw {yaw} ({yaw_ratio}\u00a0σ)."
    ),
    True: N_(
        "Significant difference from the adjustment: roll {roll} ({roll_ratio}\u00a0σ), pitch "
        "{pitch} ({pitch_ratio}\u00a0σ), yaw {yaw} ({yaw_ratio}\u00a0σ)."
    ),
}
"""Text on the difference from the adjustment by whether it is significant."""


@dataclass(frozen=True, eq=False)
class _Curve:
    """Mismatch as a function of one angle.

    Attributes
    ----------
    angle : 0 roll, 1 pitch, 2 yaw
    object_name : displayed object; None for all ticked objects
    boresight : ndarray of shape (3,), radians
        Angles for which the curve was computed.
    values : ndarray of shape (n,), radians
    mismatch : ndarray of shape (n,), metres
    """

    angle: int
    object_name: str | None
    boresight: Array
    values: Array
    mismatch: Array

    @property
    def title(self) -> str:
        """Title in the user's language."""
        name = gettext(ANGLE_NAMES[self.angle])
        if self.object_name is None:
            return gettext("Mismatch as a function of {angle}: ticked objects", angle=name)
        return gettext(
            "Mismatch as a function of {angle}: {object}", angle=name, object=self.object_name
        )


def difference_text(project: Project | None, result: PatchTestResult) -> str:
    """Differences from the adjustment of the project, with the verdict; empty without one."""
    if project is None or project.result is None or result.covariance is None:
        return ""
    # Both methods use the same lever arm.
    covariance = project.result.with_exact_lever_arm.covariance
    first = Calibration("", project.result.boresight, covariance)
    difference = compare_calibrations(first, Calibration("", result.boresight, result.covariance))
    values = {
        f"{name}{suffix}": text
        for name, angle, share in zip(
            ANGLE_NAMES, np.degrees(difference.angles), difference.significance, strict=True
        )
        for suffix, text in (
            ("", local_amount(float(angle), DEGREES.signed)),
            ("_ratio", local_number(float(share), SIGMA_RATIO.signed)),
        )
    }
    return gettext(DIFFERENCE_TEXTS[difference.differ], **values)


class PatchTestController(QObject):
    """Holds the objects, and updates the pictures when the angles change."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        controller: Controller,
        actions: Actions,
        mouse_tool: MouseTool,
        clip_box: Callable[[], ClipBox | None],
        panel: PatchTestPanel,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._scene = document, runner, scene
        self._viewport, self._controller = viewport, controller
        self._actions, self.panel = actions, panel
        self._placed_objects: PlacedObjects | None = None
        self._result: PatchTestResult | None = None
        self._survey: Survey | None = None
        self._dense_sample: ObjectSample | None = None
        self._extraction: Task | None = None
        self._mismatch: Mismatch | None = None
        self._angle = 0
        self._curve: _Curve | None = None
        self._outdated = False
        self._sketch: Sketch | None = None
        """Box of the displayed object; drawn while the panel is open."""
        self._debounce = QTimer(self, singleShot=True, interval=DEBOUNCE_MS)
        self._debounce.timeout.connect(self._compute_curve)
        panel.remove_requested.connect(self._remove)
        panel.zoom_requested.connect(self._zoom_to_object)
        panel.shown_changed.connect(self._show_object)
        panel.ticked_changed.connect(self._on_ticks_changed)
        panel.visibility_changed.connect(lambda _on: self._draw_sketch())
        panel.find_all_requested.connect(actions.guarded(self.find_all, panel))
        panel.save_requested.connect(actions.guarded(self.save_result, panel))
        panel.prior_requested.connect(self._reset_to_prior)
        panel.angles.angle_changed.connect(self._on_angle_changed)
        panel.angles.find_requested.connect(actions.guarded(self.find_angle, panel))
        panel.curve.value_clicked.connect(self._set_angle)
        self._document.survey_changed.connect(self._reset)
        self._document.changed.connect(
            lambda: self._result is not None and self._show_result(self._result)
        )
        self._runner.changed.connect(self._enable_controls)
        self._runner.idle.connect(self._on_runner_idle)
        adding = PatchObjects(
            document, runner, scene, controller, actions, mouse_tool, clip_box, self.panel,
            lambda: self._placed_objects,
        )  # fmt: skip
        adding.objects_placed.connect(self._set_objects)
        self._reset()

    # -- objects -----------------------------------------------------------------------------

    def _remove(self, name: str) -> None:
        if self._placed_objects is not None and name:
            left = [each.name for each in self._placed_objects.objects if each.name != name]
            self._set_objects(self._placed_objects.select_objects(left) if left else None)

    def _set_objects(self, placed_objects: PlacedObjects | None, shown: str = "") -> None:
        panel = self.panel
        unticked = {n for n in self._object_names() if n not in panel.ticked_entries}
        self._placed_objects = placed_objects
        panel.show_objects(self._object_names(), unticked, shown or panel.shown)
        self._discard_result()
        self._show_object()
        self._enable_controls()
        if shown and not panel.isVisible():
            raise_panel(panel)  # an object was added with the menu

    def _object_names(self) -> list[str]:
        return (
            []
            if self._placed_objects is None
            else [each.name for each in self._placed_objects.objects]
        )

    def _zoom_to_object(self, name: str) -> None:
        each = self._find_object(name)
        if each is not None:
            self._viewport.fit(_clip_box(each.box).corners)

    def _find_object(self, name: str) -> PatchObject | None:
        objects = () if self._placed_objects is None else self._placed_objects.objects
        return next((each for each in objects if each.name == name), None)

    # -- display -----------------------------------------------------------------------------

    def _show_object(self) -> None:
        """Show the selected object, or update it."""
        each, survey = self._find_object(self.panel.shown), self._survey
        if each is None or survey is None or self._placed_objects is None:
            self._dense_sample = self._mismatch = None
            self.panel.picture.show_points({}, {}, np.ones(2))
            self._set_sketch(None)
            return
        corners = _clip_box(each.box).corners
        self._set_sketch(
            Sketch(
                tuple((float(x), float(y), float(z)) for x, y, z in corners),
                BOX_EDGES,
                SKETCH_COLOUR,
                label=each.name,
                label_point=tuple(each.box.centre.tolist()),
            )
        )
        sample = self._placed_objects.sample.of_objects([each.name])
        shown = PlacedObjects((each,), (self._placed_objects.boresight,), sample)
        self._mismatch = Mismatch(sample, shown.blocks([each.name], self._ticked_line_pairs()))
        self._show_curve(None)
        if self._dense_sample is None or self._dense_sample.observed[0].object is not each:
            self._dense_sample = None
            self._extract_dense_points(each, self._placed_objects, survey)
        self._draw_lines()

    def _extract_dense_points(
        self, each: PatchObject, placed_objects: PlacedObjects, survey: Survey
    ) -> None:
        """Extract the points to draw in the worker; the picture is kept until they are ready."""

        def work(_progress: Progress) -> ObjectSample:
            return ObjectSample.of(
                [each], placed_lines(placed_objects, survey), survey.scans, limit=MAX_POINTS
            )

        def done(dense_sample: ObjectSample) -> None:
            if self._find_object(self.panel.shown) is each:
                self._dense_sample = dense_sample
                self._draw_lines()

        title = gettext("Extracting the points of {name}", name=each.name)
        self._extraction = self._runner.run(title, work, done, quiet=True, key="patching")

    def _on_runner_idle(self) -> None:
        if (
            self._dense_sample is None
            and self._extraction is not None
            and self._extraction.superseded
        ):
            self._show_object()
        if self._outdated:
            self._debounce.start()

    def _on_angle_changed(self, angle: int) -> None:
        self._angle = angle
        self._draw_lines()

    def _set_angle(self, value: float) -> None:
        boresight = self.panel.angles.boresight
        boresight[self._angle] = value
        self.panel.angles.set_angles(boresight)
        self._draw_lines()

    def _draw_lines(self) -> None:
        """Draw the lines with the current angles; the curve follows after a pause."""
        each = self._find_object(self.panel.shown)
        if (
            each is None
            or self._dense_sample is None
            or self._survey is None
            or self._mismatch is None
        ):
            return
        boresight = self.panel.angles.boresight
        across, up, size = _view_axes(each.box, self.panel.view.currentIndex())
        placed = self._dense_sample.placed_points(boresight) - each.box.centre
        points = {
            part.line: placed[part.points] @ np.column_stack([across, up])
            for part in self._dense_sample.observed
        }
        colours = theme.line_colours(self._survey.lines)
        self.panel.picture.show_points(points, colours, size)
        curve, value = self.panel.curve, float(boresight[self._angle])
        mismatch = float("nan")
        if self.panel.of.currentIndex() == 0:
            mismatch = self._mismatch(boresight) if self._mismatch.blocks else float("nan")
        curve.mark_current(value, mismatch)
        if not self._is_curve_current(boresight):
            self._outdated = True
            self._debounce.start()

    def _is_curve_current(self, boresight: Array) -> bool:
        curve = self._curve
        if curve is None or curve.angle != self._angle:
            return False
        at = curve.boresight
        others = [k for k in range(3) if k != self._angle]
        moved = abs(boresight[self._angle] - at[self._angle])
        return bool((boresight[others] == at[others]).all()
                    and moved <= CURVE_INNER_SHARE * CURVE_HALF_WIDTH)  # fmt: skip

    def _show_curve(self, curve: _Curve | None) -> None:
        """Show a curve; None while it is not known."""
        self._curve = curve
        if curve is None:
            self.panel.curve.show_curve("", np.empty(0), np.empty(0))
        else:
            self.panel.curve.show_curve(curve.title, curve.values, curve.mismatch)

    def _compute_curve(self) -> None:
        placed_objects, angle, each = (
            self._placed_objects,
            self._angle,
            self._find_object(self.panel.shown),
        )
        if placed_objects is None or each is None or self._runner.busy:
            return
        for_all = self.panel.of.currentIndex() == 1
        names = self.panel.ticked_entries if for_all else (each.name,)
        boresight, pairs = self.panel.angles.boresight, self._ticked_line_pairs()
        steps = CURVE_STEPS["all" if for_all else "one"]

        def work(progress: Progress) -> tuple[Array, Array]:
            mismatch = Mismatch(placed_objects.sample, placed_objects.blocks(names, pairs))
            for half_width, count in (
                (CURVE_HALF_WIDTH, steps),
                (WIDENING_FACTOR * CURVE_HALF_WIDTH, 3 * steps),
            ):
                values = boresight[angle] + np.linspace(-half_width, half_width, count)
                if not mismatch.blocks:
                    return values, np.full(count, np.nan)
                found = np.empty(count)
                for k, value in enumerate(values):
                    progress(k / count)
                    found[k] = mismatch.mismatch_curve(boresight, angle, np.array([value]))[0]
                if curve_minimum(values, found) is not None:
                    break
            return values, found

        def done(curve: tuple[Array, Array]) -> None:
            self._outdated = False
            name = None if for_all else each.name
            self._show_curve(_Curve(angle, name, boresight, *curve))
            if not self._is_curve_current(self.panel.angles.boresight):
                self._debounce.start()

        self._runner.run(gettext("Computing the curve"), work, done, quiet=True, key="patch_curve")

    # -- searching ---------------------------------------------------------------------------

    def find_angle(self, angle: int) -> None:
        """Minimise the mismatch over one angle."""
        placed_objects = self._placed_objects
        if placed_objects is None:
            return
        names, pairs, start = (
            self.panel.ticked_entries,
            self._ticked_line_pairs(),
            self.panel.angles.boresight,
        )

        def done(result: MismatchMinimum) -> None:
            self._angle = angle
            self.panel.angles.set_start(result.boresight, RESULT_RANGE_DEG)
            degrees = float(np.degrees(result.boresight[angle]))
            self.panel.message_label.setText(
                gettext(
                    "The mismatch is smallest at {angle} {value}, with the other angles unchanged.",
                    angle=gettext(ANGLE_NAMES[angle]),
                    value=local_amount(degrees, DEGREES.signed),
                )
            )
            self._draw_lines()

        self._runner.run(
            gettext("Optimising {angle}", angle=gettext(ANGLE_NAMES[angle])),
            lambda progress: find_angle(
                placed_objects, placed_objects.blocks(names, pairs), start, angle, progress=progress
            ),
            done,
        )

    def find_all(self) -> None:
        """Estimate all three angles with their standard deviations."""
        project, survey = self._document.current_data
        if project is None or survey is None or self._placed_objects is None:
            return
        placed_objects, pairs = (
            self._placed_objects.select_objects(self.panel.ticked_entries),
            self._ticked_line_pairs(),
        )

        def work(progress: Progress) -> PatchTestResult:
            start = survey.alignment.mounting.boresight
            return find_boresight(
                project, survey, placed_objects, pairs=pairs, start=start, progress=progress
            )

        def done(result: PatchTestResult) -> None:
            self._result = result
            self.panel.angles.set_start(result.boresight, RESULT_RANGE_DEG)
            self._show_result(result)
            self._draw_lines()
            self._enable_controls()

        task = self._runner.run(gettext("Patch test"), work, done)
        self._controller.cancel_on_edit(task)

    def save_result(self) -> None:
        """Add the result to the alternative methods of the project, as one undo step."""
        project = self._document.project
        if project is None or self._result is None:
            return
        try:
            alternative = patch_test_result(self._result)
        except LispacError as error:
            self._controller.refused.emit(error)
            return
        self._document.edit(
            N_("result of the patch test"), project.with_alternative_result(alternative)
        )
        self._controller.logged.emit(
            gettext("The result of the patch test was added to the project.")
        )

    def _reset_to_prior(self) -> None:
        survey = self._survey
        if survey is not None:
            prior = next(iter(survey.clouds.values())).place.mounting.boresight
            self.panel.angles.set_start(prior)
            self._draw_lines()

    def copy_state_from(self, former: "PatchTestController") -> None:
        """Take over the objects, angles and results of a former window with the same data."""
        if former._survey is None or former._survey is not self._survey:
            return
        self._placed_objects, self._dense_sample = former._placed_objects, former._dense_sample
        self._angle, self._result = former._angle, former._result
        panel = self.panel
        panel.copy_choices_from(former.panel)
        if self._result is not None:
            self._show_result(self._result)
        panel.angles.copy_state_from(former.panel.angles)
        self._show_object()
        if former._curve is not None:  # another one would have another interval
            self._debounce.stop()
            self._outdated = False
            self._show_curve(former._curve)
            self._draw_lines()
        self._enable_controls()

    def _show_result(self, result: PatchTestResult) -> None:
        self.panel.angles.show_found(PatchTestValues.of(result))
        compared = difference_text(self._document.project, result)
        texts = (compared, *map(message_text, result.messages))
        self.panel.message_label.setText("\n".join(filter(None, texts)))
        self.panel.mark_objects(
            {each.name: each.disagreement for each in result.disagreeing_objects}
        )

    # -- state -------------------------------------------------------------------------------

    @property
    def last_result(self) -> PatchTestResult | None:
        """Result of the last search for all angles; None if there is none."""
        return self._result

    @property
    def is_curve_pending(self) -> bool:
        """Whether the curve still has to be computed for the current angles."""
        return self._outdated

    def _ticked_line_pairs(self) -> tuple[LinePair, ...]:
        if self._survey is None:
            return ()
        ticked = self.panel.ticked_pairs
        return tuple(pair for pair in line_pairs(self._survey) if pair.name in ticked)

    def _on_ticks_changed(self) -> None:
        self._discard_result()
        self._show_object()
        self._enable_controls()

    def _discard_result(self) -> None:
        """Discard the result, which depends on other objects or pairs."""
        self._result = None
        self.panel.angles.show_found(None)
        self.panel.message_label.setText("")
        self.panel.mark_objects({})

    def _reset(self) -> None:
        """Discard the objects when the data change."""
        _, survey = self._document.current_data
        if survey is not None and survey is self._survey:
            return
        self._survey, self._placed_objects, self._result = survey, None, None
        self._dense_sample = self._mismatch = None
        self._outdated = False
        has_lines = survey is not None and len(survey.clouds) > 1
        self.panel.show_empty(EMPTY_TEXT if has_lines else NO_DATA_TEXT)
        self.panel.show_pairs(line_pairs(survey) if survey is not None else ())
        self._show_curve(None)
        self._discard_result()
        self._set_sketch(None)
        self._reset_to_prior()
        self._enable_controls()

    def _enable_controls(self) -> None:
        survey = self._survey
        no_data = first_reason(
            (self._document.project is None, Unavailable.NO_PROJECT),
            (survey is None, Unavailable.READING),
            (survey is not None and len(survey.clouds) < 2, Unavailable.ONE_LINE),
        )
        self.panel.update_enabled(
            no_data, busy=self._runner.busy, has_result=self._result is not None
        )

    def _set_sketch(self, sketch: Sketch | None) -> None:
        if sketch is not self._sketch:
            self._sketch = sketch
            self._draw_sketch()

    def _draw_sketch(self) -> None:
        self._viewport.show_sketch(SKETCH_NAME, self._sketch if self.panel.isVisible() else None)


def placed_lines(placed_objects: PlacedObjects, survey: Survey):
    """Lines georeferenced with the boresight of the objects, or the prior if it is unknown."""
    from lispac.survey.cloud import place_clouds

    if not np.isfinite(placed_objects.boresight).all():
        return survey.clouds
    mounting = next(iter(survey.clouds.values())).place.mounting
    return place_clouds(survey.clouds, mounting.with_boresight(placed_objects.boresight))


def _clip_box(box: ObjectBox) -> ClipBox:
    return ClipBox(box.centre, box.axes, 0.5 * box.size)


def _view_axes(box: ObjectBox, view: int) -> tuple[Array, Array, Array]:
    """Directions to the right and upwards in a picture, and its size with a margin, metres."""
    ahead, left, up = box.axes
    margin = 0.3
    if view == 0:
        return -left, ahead, box.size[[1, 0]] + margin
    if view == 1:
        return -left, up, box.size[[1, 2]] + margin
    return ahead, up, box.size[[0, 2]] + margin
