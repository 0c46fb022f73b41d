"""Content of the viewport: lines before or after the adjustment, sightings and labels."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from lispac.geometry.radius_search import nearest_point
from lispac.gui.app.point_colours import Colouring, point_shading, sighting_shades
from lispac.gui.appearance import theme
from lispac.gui.project.document import Document
from lispac.gui.project.residuals import residual_shading
from lispac.gui.viewport.base import (
    SHADED_EDGE_COLOUR,
    Array,
    Highlight,
    Marker,
    PickedPoint,
    PointColouring,
    Viewport,
)
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.project import Target, Triple
from lispac.survey.cloud import Cloud, Numbers

PriorOrEstimated = Literal["prior", "estimated"]
"""Boresight with which the lines are georeferenced."""
SURROUNDINGS = 5.0
"""Extent of the view of a proposed target, as a multiple of that of the target, so that the
structure that it belongs to can be seen."""
ResidualColours = Mapping[tuple[str, str], NDArray[np.uint8]]
"""Colours of the points of each sighting by their residuals, by target and line."""
ColouredPoints = tuple[PointColouring | None, ResidualColours]


def proposed_key(name: str) -> str:
    """Key of a proposed target in the viewport."""
    return f"\n{name}"  # no target has a line break in its name


class Scene(QObject):
    """Updates the viewport from the document, the candidate and the before/after switch."""

    which_changed = Signal(str)
    colouring_changed = Signal(str)
    focused = Signal(object, str)
    """Points (n, 3) to which the view moves, and the name of their target or line."""
    selection_changed = Signal()
    drawn = Signal()
    """The lines were drawn again."""
    targets_drawn = Signal()
    """The sightings were drawn again."""
    placement_requested = Signal()
    """The lines shown after the adjustment must be georeferenced with the current result."""

    def __init__(self, document: Document, viewport: Viewport, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._viewport = document, viewport
        self._estimated: tuple[object, Mapping[str, Cloud]] | None = None
        self._former: Scene | None = None
        self.which: PriorOrEstimated = "prior"
        self.candidate: Target | None = None
        self._proposed: tuple[Target, ...] = ()
        self._selected_proposed = ""
        self._ticked: frozenset[str] = frozenset()
        """Names of the proposed targets that the user has ticked."""
        self.selected: tuple[str, str] | None = None
        self._colouring: Colouring = "line"
        self._drawn: Mapping[str, Cloud] = {}
        self._shading: PointColouring | None = None
        self._residuals: ResidualColours = {}
        self._lost_estimated = False
        """Whether the lines are shown before the adjustment because the result was removed."""
        self._markers: list[Marker] = []
        self._searched: tuple[Marker, ...] = ()
        """Seeds of the running and queued searches."""
        self._shaded: ColouredPoints | None = None
        """Colours that were computed but not yet drawn; None if there are none."""
        # One task for several changes in a row, as when a project is opened.
        self._lines_due = IdleTask(self._draw_due_lines, self)
        self._targets_due = IdleTask(self._draw_due_targets, self)
        document.about_to_open.connect(self._clear)
        document.survey_changed.connect(self._reload)
        document.changed.connect(self._on_project_changed)

    @property
    def colouring(self) -> Colouring:
        """Value by which the points are coloured; by line in a project that was just opened."""
        return self._colouring

    def _set_colouring(self, colouring: Colouring) -> None:
        if colouring != self._colouring:
            self._colouring = colouring
            self.colouring_changed.emit(colouring)

    @property
    def clouds(self) -> Mapping[str, Cloud]:
        """Lines as displayed."""
        return self.clouds_of(self.which)

    def clouds_of(self, which: PriorOrEstimated) -> Mapping[str, Cloud]:
        """Lines before or after the adjustment; before if they are not georeferenced with it."""
        survey = self._document.survey
        if survey is None:
            return {}
        if which == "estimated" and self._estimated is not None:
            return self._estimated[1]
        return survey.clouds

    @property
    def has_estimated(self) -> bool:
        """Whether the lines are georeferenced with the current result."""
        project = self._document.project
        return (
            self._estimated is not None
            and project is not None
            and project.result is not None
            and self._estimated[0] is project.result
        )

    @property
    def selected_points(self) -> dict[str, Array]:
        """Points (n, 3) of the selection by line, as displayed; empty without a selection."""
        project = self._document.project
        if project is None or self.selected is None:
            return {}
        name, line = self.selected
        target = next((target for target in project.targets if target.name == name), None)
        return {} if target is None else _points_by_line(target, self.clouds, line)

    def prior_position_finder(self, point: PickedPoint) -> Callable[[], Triple]:
        """Function, callable in any thread, that finds the prior position of a clicked point.

        Targets are searched for in the lines georeferenced with the prior boresight.
        """
        survey = self._document.survey
        if survey is None or self.which == "prior":
            return lambda: point.position
        shown, prior = self.clouds[point.line].sample, survey.clouds[point.line].sample

        def find() -> Triple:
            nearest, _ = nearest_point(shown, np.array(point.position))
            north, west, up = (float(v) for v in prior[nearest])
            return north, west, up

        return find

    def sample_index(self, point: PickedPoint) -> int | None:
        """Index of a drawn point in the sample of its line; None if the line was drawn again."""
        cloud = self.clouds.get(point.line)
        if cloud is None:
            return None
        sample, place = cloud.sample, np.array(point.position)
        rows = np.flatnonzero(sample[:, 0] == place[0])  # few, so that the rest takes no time
        rows = rows[(sample[rows] == place).all(axis=1)]
        return int(rows[0]) if len(rows) else None

    def show_searches(self, marks: Sequence[tuple[str, Triple]]) -> None:
        """Mark the seeds of running and queued searches by labels and positions."""
        searched = tuple(
            Marker(label, at, theme.CANDIDATE_COLOUR, is_provisional=True) for label, at in marks
        )
        if searched != self._searched:
            self._searched = searched
            self._show_markers()

    def colour_by(self, colouring: Colouring) -> None:
        """Colour the points by line or by a value.

        Raises
        ------
        ValueError
            If a line lacks the values, or if residuals are requested and there is no result; the
            colours are then unchanged.
        """
        shaded = self._point_colours(colouring)
        self._set_colouring(colouring)
        if self._document.survey is not None:
            self._draw_clouds(shaded)
            self._schedule_targets()

    def keep_estimated(self, result: object, clouds: Mapping[str, Cloud]) -> None:
        """Store the lines georeferenced with ``result``."""
        self._estimated = (result, clouds)

    def reassign_estimated(self, old: object, new: object) -> None:
        """Assign the georeferenced lines of one result to another with the same mounting."""
        if self._estimated is not None and self._estimated[0] is old:
            self._estimated = (new, self._estimated[1])

    def show(self, which: PriorOrEstimated) -> None:
        """Show the lines before the adjustment, or after it if they are georeferenced with it."""
        self._lost_estimated = False
        if which == "estimated" and not self.has_estimated:
            which = "prior"
        if which != self.which or self.clouds is not self._drawn:
            self.which = which
            self._draw_clouds()
            self._schedule_targets()
        self.which_changed.emit(self.which)

    def continue_from(self, former: "Scene") -> None:
        """Show what another scene of the same document shows, when the document is opened."""
        self._former = former

    def show_candidate(self, candidate: Target | None) -> None:
        """Show the candidate beside the other targets."""
        self.candidate = candidate
        self._schedule_targets()
        self._viewport.select(None if candidate is None else (candidate.name, ""))

    def show_proposed(self, targets: Sequence[Target], ticked: Collection[str]) -> None:
        """Show proposed targets beside those of the project, the ones not ``ticked`` in grey."""
        proposed, names = tuple(targets), frozenset(ticked)
        if (proposed, names) != (self._proposed, self._ticked):
            if not proposed:
                self._viewport.select(self.selected)
            self._proposed, self._ticked = proposed, names
            self._schedule_targets()

    def select_proposed(self, name: str) -> None:
        """Highlight a proposed target, and move the view to it if it is outside the picture."""
        target = next((each for each in self._proposed if each.name == name), None)
        if target is None:
            return
        self._selected_proposed = name
        self._viewport.select((proposed_key(name), ""))
        self._show_markers()
        self.bring_into_view(target)

    def zoom_to_proposed(self, name: str) -> None:
        """Move the view to a proposed target."""
        target = next((each for each in self._proposed if each.name == name), None)
        groups = {} if target is None else _points_by_line(target, self.clouds)
        if groups:
            self._viewport.fit(np.concatenate(list(groups.values())))

    def bring_into_view(self, target: Target) -> None:
        """Move the view to a target whose label is outside the picture, and its surroundings."""
        groups = _points_by_line(target, self.clouds)
        x, y = self._viewport.to_pixels(np.array([_label_position(target, groups)]))[0]
        rect = self._viewport.widget.rect()
        if groups and not (0 <= x < rect.width() and 0 <= y < rect.height()):
            points = np.concatenate(list(groups.values()))
            middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
            self._viewport.fit(middle + SURROUNDINGS * (points - middle))

    def select(self, name: str, line: str = "") -> None:
        """Highlight a sighting, or a target if ``line`` is empty, without moving the view."""
        self.selected = (name, line)
        self._viewport.select(self.selected)
        self._show_markers()
        self.selection_changed.emit()

    def focus_on(self, name: str, line: str) -> None:
        """Highlight a sighting, or a target if ``line`` is empty, and move the view to it."""
        project = self._document.project
        if project is None:
            return
        target = project.target(name)
        self.selected = (name, line)
        self._viewport.select((name, line))
        self._show_markers()
        groups = _points_by_line(target, self.clouds, line)
        if groups:
            points = np.concatenate(list(groups.values()))
            self.focused.emit(points, name)
            self._viewport.fit(points)
        self.selection_changed.emit()

    def _clear(self) -> None:
        self.candidate = self.selected = None
        self._proposed = ()
        self.which, self._lost_estimated = "prior", False
        self._set_colouring("line")
        self._markers, self._searched = [], ()
        self._viewport.clear()  # not redrawn before the next project
        self._drawn = {}

    def _reload(self) -> None:
        former, self._former = self._former, None
        if former is None:
            # Also an edit that moves the lines: Undo shows them after the adjustment again
            self._lost_estimated = self._lost_estimated or self.which == "estimated"
            self._estimated, self.which = None, "prior"
        else:
            self._estimated, self.which = former._estimated, former.which
            self._set_colouring(former.colouring)
        survey = self._document.survey
        if survey is None:
            self._viewport.clear()
            self._drawn = {}
        else:
            # Standard views look from the water, where the vessel was during the scans.
            self._viewport.set_station(_mean_vessel_position(survey))
        self._schedule_lines()
        self.which_changed.emit(self.which)
        project = self._document.project
        has_result = project is not None and project.result is not None
        if former is None and survey is not None and has_result:
            self.placement_requested.emit()  # a project with a result is shown after the adjustment

    def _on_project_changed(self) -> None:
        project = self._document.project
        if self.which == "estimated" and not self.has_estimated:
            if project is not None and project.result is not None:
                self.placement_requested.emit()  # drawn lines are kept until then
            elif not self._document.awaits_result:
                self.which, self._lost_estimated = "prior", True
                self.which_changed.emit(self.which)
        elif self._lost_estimated and project is not None and project.result is not None:
            self.placement_requested.emit()  # as after opening; Undo has restored the result
        outdated = self.colouring == "residual" and not self._document.awaits_result
        if outdated or self.clouds is not self._drawn:
            self._schedule_lines()
        self._schedule_targets()

    @property
    def awaits_lines(self) -> bool:
        """Whether lines are still to be drawn; `drawn` follows."""
        return self._lines_due.isActive()

    @property
    def is_drawn(self) -> bool:
        """Whether no drawing is pending."""
        return not (self._lines_due.isActive() or self._targets_due.isActive())

    def draw_now(self) -> None:
        """Draw what is still to be drawn, as in a window that replaces another one."""
        while self._lines_due.isActive():
            self._draw_due_lines()
        if self._targets_due.isActive():
            self._draw_due_targets()

    def _schedule_lines(self) -> None:
        self._shaded = None
        self._lines_due.start()

    def _draw_due_lines(self) -> None:
        self._lines_due.stop()
        if self._document.survey is not None:
            if self.colouring != "line" and self._shaded is None:
                self._shaded = self._available_colours()  # drawn in the next turn
                self._lines_due.start()
                return
            is_first = not self._drawn
            self._draw_clouds(self._shaded)
            if is_first:
                self._draw_due_targets()  # the first picture has the targets too
                return
        self._schedule_targets()

    def _draw_clouds(self, shaded: ColouredPoints | None = None) -> None:
        clouds = self._drawn = self.clouds
        samples = {name: cloud.sample for name, cloud in clouds.items()}
        self._shading, self._residuals = shaded or self._available_colours()
        self._shaded = None
        self._viewport.show_clouds(samples, theme.line_colours(list(clouds)), self._shading)
        self.drawn.emit()

    def _available_colours(self) -> ColouredPoints:
        try:
            return self._point_colours(self.colouring)
        except ValueError:  # no intensities or no result
            self._set_colouring("line")
            return None, {}

    def _point_colours(self, colouring: Colouring) -> ColouredPoints:
        """Colours of the points of the lines, and of sightings that have separate colours."""
        if colouring != "residual":
            return point_shading(colouring, self.clouds), {}
        project, survey = self._document.project, self._document.survey
        if project is None or survey is None:
            return None, {}
        return residual_shading(project, survey, self.clouds)

    def _schedule_targets(self) -> None:
        if not self._lines_due.isActive():  # drawn after the lines
            self._targets_due.start()

    def _draw_due_targets(self) -> None:
        self._targets_due.stop()
        self._viewport.show_highlights(self.highlights(self.which))
        self._markers = [self._marker(target) for target in self._shown_targets()]
        self._show_markers()
        self.targets_drawn.emit()

    def _show_markers(self) -> None:
        """Show the names of the targets, that of the selected one filled, and the searches."""
        selected = "" if self.selected is None else self.selected[0]
        if self._proposed:
            selected = f"{self._selected_proposed}?"
        markers = [replace(each, is_selected=each.label == selected) for each in self._markers]
        self._viewport.show_markers([*markers, *self._searched])

    def _shown_targets(self) -> list[Target]:
        project = self._document.project
        targets = [] if project is None or self._document.survey is None else list(project.targets)
        if self.candidate is not None:
            targets = [t for t in targets if t.name != self.candidate.name] + [self.candidate]
        return [*targets, *self._proposed]

    def highlights(self, which: PriorOrEstimated) -> list[Highlight]:
        """Sightings of all targets and of the candidate, before or after the adjustment."""
        project, clouds = self._document.project, self.clouds_of(which)
        line_colours = theme.line_colours(list(clouds))
        result = None if project is None else project.result
        rejected = {
            (each.target, each.line) for each in (result.rejected_sightings if result else ())
        }
        highlights = []
        for target in self._shown_targets():
            groups = _points_by_line(target, clouds)
            for sighting in target.sightings:
                points = groups.get(sighting.line)
                if points is not None:
                    key = self._key(target), sighting.line
                    used = target.used and sighting.used and key not in rejected
                    used &= not self._is_unticked(target)
                    colour = line_colours[sighting.line] if used else theme.UNUSED_COLOUR
                    halo = self._colour(target) if used else theme.UNUSED_COLOUR
                    shades = self._shades(key, points, sighting.indices) if used else None
                    if shades is not None and self.colouring == "residual":
                        halo = SHADED_EDGE_COLOUR  # the scale has the colours of the halos
                    highlights.append(Highlight(key, points, colour, halo, shades))
        return highlights

    def _shades(
        self, key: tuple[str, str], points: Array, numbers: Numbers
    ) -> NDArray[np.uint8] | None:
        """Colours of the points of a sighting by the present colouring; None for one colour."""
        survey = self._document.survey
        if self.colouring == "residual":
            shades = self._residuals.get(key)
            # The points may have been edited since the adjustment.
            return shades if shades is not None and len(shades) == len(points) else None
        if self._shading is None or survey is None:
            return None
        return sighting_shades(self.colouring, self._shading, survey.scans[key[1]], points, numbers)

    def _marker(self, target: Target) -> Marker:
        is_found = target is self.candidate or self._is_proposed(target)
        label = f"{target.name}?" if is_found else target.name
        position = _label_position(target, _points_by_line(target, self.clouds))
        return Marker(label, position, self._colour(target), is_provisional=is_found)

    def _key(self, target: Target) -> str:
        return proposed_key(target.name) if self._is_proposed(target) else target.name

    def _is_proposed(self, target: Target) -> bool:
        return any(each is target for each in self._proposed)

    def _is_unticked(self, target: Target) -> bool:
        return self._is_proposed(target) and target.name not in self._ticked

    def _colour(self, target: Target):
        if target is self.candidate:
            return theme.CANDIDATE_COLOUR
        if self._is_unticked(target):
            return theme.UNUSED_COLOUR
        return theme.TARGET_COLOUR if target.role == "target" else theme.VALIDATION_COLOUR


def _points_by_line(
    target: Target, clouds: Mapping[str, Cloud], line: str = ""
) -> dict[str, Array]:
    """Points (n, 3) of a target on each line, or on one line."""
    return {
        each.line: clouds[each.line][each.indices]
        for each in target.sightings
        if each.line in clouds and line in ("", each.line)
    }


def _label_position(target: Target, groups: dict[str, Array]) -> tuple[float, float, float]:
    """Position of the label of a target: the mean of its points, or its seed."""
    if not any(len(points) for points in groups.values()):
        return target.seed
    x, y, z = (float(v) for v in np.concatenate(list(groups.values())).mean(axis=0))
    return x, y, z


def _mean_vessel_position(survey) -> tuple[float, float, float]:
    """Mean position of the vessel during the scans: the station of the standard views."""
    times = np.concatenate(
        [np.linspace(scan.first_time, scan.last_time, 21) for scan in survey.scans.values()]
    )
    north, west, up = (float(v) for v in survey.trajectory.at(times).position.mean(axis=0))
    return north, west, up
