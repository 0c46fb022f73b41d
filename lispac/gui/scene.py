"""What the viewport shows: the lines before or after, the sightings, the labels."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from lispac.geometry.neighbours import nearest_point
from lispac.gui import theme
from lispac.gui.document import Document
from lispac.gui.idle_tasks import IdleTask
from lispac.gui.point_colours import Colouring, shading
from lispac.gui.residuals import residual_reach, residual_shading
from lispac.gui.viewport.base import Array, Highlight, Marker, PickedPoint, Shading, Viewport
from lispac.project import Target, Triple
from lispac.survey.cloud import Cloud

Which = Literal["prior", "estimated"]
Residuals = Mapping[tuple[str, str], NDArray[np.uint8]]
"""Colours of the points of a sighting, by target and line."""
Shaded = tuple[Shading | None, Residuals]


class Scene(QObject):
    """Keeps the viewport in step with the document, the candidate and the before/after switch."""

    which_changed = Signal(str)
    gone_to = Signal(object, str)
    """Points (n, 3) that the view goes to, and what they are of."""
    selection_changed = Signal()
    drawn = Signal()
    """The lines are drawn anew."""
    placing_wanted = Signal()
    """The lines after are shown, and the project has another result by now."""

    def __init__(self, document: Document, viewport: Viewport, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._viewport = document, viewport
        self._estimated: tuple[object, Mapping[str, Cloud]] | None = None
        self.which: Which = "prior"
        self.candidate: Target | None = None
        self.selected: tuple[str, str] | None = None
        self.colouring: Colouring = "line"
        self._drawn: Mapping[str, Cloud] = {}
        self._residuals: Residuals = {}
        self._reach: float | None = None
        self._shaded: Shaded | None = None
        """Colours that wait to be drawn."""
        # Once for all that changes in one: a new project has enough to show.
        self._lines_due = IdleTask(self._put_lines, self)
        self._targets_due = IdleTask(self._put_targets, self)
        document.left.connect(self._leave)
        document.survey_changed.connect(self._reload)
        document.changed.connect(self._project_changed)

    @property
    def clouds(self) -> Mapping[str, Cloud]:
        """The lines as they are shown."""
        survey = self._document.survey
        if survey is None:
            return {}
        if self.which == "estimated" and self._estimated is not None:
            return self._estimated[1]
        return survey.clouds

    @property
    def has_estimated(self) -> bool:
        """Whether the lines placed with the present result are at hand."""
        project = self._document.project
        return (
            self._estimated is not None
            and project is not None
            and project.result is not None
            and self._estimated[0] is project.result
        )

    @property
    def selected_points(self) -> dict[str, Array]:
        """Points (n, 3) of what is selected, by line, as they are shown; empty without any."""
        project = self._document.project
        if project is None or self.selected is None:
            return {}
        name, line = self.selected
        target = next((target for target in project.targets if target.name == name), None)
        return {} if target is None else self._points_by_line(target, line)

    def to_prior(self, point: PickedPoint) -> Callable[[], Triple]:
        """What finds, in any thread, where a clicked point lies with the prior boresight.

        Targets are searched for in those lines.
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

    def colour_by(self, colouring: Colouring) -> None:
        """Colour the points.

        Raises
        ------
        ValueError
            Where a line has nothing to colour by; nothing changes then.
        """
        shaded = self._shades(colouring)
        self.colouring = colouring
        if self._document.survey is not None:
            self._draw_clouds(shaded)
            self._draw_targets()

    def keep_estimated(self, result: object, clouds: Mapping[str, Cloud]) -> None:
        """Keep the lines placed with ``result``."""
        self._estimated = (result, clouds)

    def keep_placed(self, old: object, new: object) -> None:
        """The lines placed with one result are those of another with the same mounting."""
        if self._estimated is not None and self._estimated[0] is old:
            self._estimated = (new, self._estimated[1])

    def show(self, which: Which) -> None:
        """Show the lines before or after."""
        if which == "estimated" and not self.has_estimated:
            which = "prior"
        if which != self.which or self.clouds is not self._drawn:
            self.which = which
            self._draw_clouds()
            self._draw_targets()
        self.which_changed.emit(self.which)

    def take_over(self, former: "Scene") -> None:
        """Show what another scene of the same document shows; what it has placed is not again."""
        self._estimated, self.which = former._estimated, former.which
        self.colouring = former.colouring
        self._draw_lines()
        self.which_changed.emit(self.which)

    def show_candidate(self, candidate: Target | None) -> None:
        """Show a target just found beside the others."""
        self.candidate = candidate
        self._draw_targets()
        self._viewport.select(None if candidate is None else (candidate.name, ""))

    def select(self, name: str) -> None:
        """Emphasise a target on all its lines, and stay where the view is."""
        self.selected = (name, "")
        self._viewport.select(self.selected)
        self.selection_changed.emit()

    def look_at(self, name: str, line: str) -> None:
        """Emphasise a sighting, or a target on all its lines with ``line`` "", and go there."""
        project = self._document.project
        if project is None:
            return
        target = project.target(name)
        self.selected = (name, line)
        self._viewport.select((name, line))
        points = self._points(target, line)
        if points is not None:
            self.gone_to.emit(points, name)
            self._viewport.fit(points)
        self.selection_changed.emit()

    @contextmanager
    def one_scale(self) -> Iterator[None]:
        """While this lasts, a colour by residual means the same before and after."""
        project, survey, shown = self._document.project, self._document.survey, self.which
        estimated = self._estimated
        coloured = self.colouring == "residual" and self.has_estimated
        if coloured and project and survey and estimated:
            self._reach = residual_reach(project, survey, (survey.clouds, estimated[1]))
            self._drawn = {}  # drawn anew, with the other colours
        try:
            yield
        finally:
            if self._reach is not None:
                self._reach, self._drawn = None, {}
            self.show(shown)

    def _leave(self) -> None:
        self.candidate = self.selected = None
        self._viewport.clear()  # nothing of it is drawn once more on the way to another
        self._drawn = {}

    def _reload(self) -> None:
        self._estimated = None
        self.which = "prior"
        survey = self._document.survey
        if survey is None:
            self._viewport.clear()
            self._drawn = {}
        else:
            # Standard views look from the water, where the vessel was while it scanned.
            self._viewport.set_station(_vessel(survey))
        self._draw_lines()
        self.which_changed.emit(self.which)

    def _project_changed(self) -> None:
        project = self._document.project
        if self.which == "estimated" and not self.has_estimated:
            if project is not None and project.result is not None:
                self.placing_wanted.emit()  # the lines as they are stay until the others are there
            elif not self._document.awaits_result:
                self.which = "prior"
                self.which_changed.emit(self.which)
        stale = self.colouring == "residual" and not self._document.awaits_result
        if stale or self.clouds is not self._drawn:
            self._draw_lines()
        self._draw_targets()

    @property
    def awaits_lines(self) -> bool:
        """Whether lines are drawn in one of the next turns; `drawn` follows."""
        return self._lines_due.isActive()

    @property
    def is_drawn(self) -> bool:
        """Whether nothing is to be drawn in the next turns."""
        return not (self._lines_due.isActive() or self._targets_due.isActive())

    def draw_due(self) -> None:
        """Draw now what would be drawn in the next turns."""
        while self._lines_due.isActive():
            self._put_lines()
        if self._targets_due.isActive():
            self._put_targets()

    def _draw_lines(self) -> None:
        self._shaded = None
        self._lines_due.start()

    def _put_lines(self) -> None:
        self._lines_due.stop()
        if self._document.survey is not None:
            if self.colouring != "line" and self._shaded is None:
                self._shaded = self._shades_of_any()  # in a turn of its own
                self._lines_due.start()
                return
            self._draw_clouds(self._shaded)
        self._draw_targets()

    def _draw_clouds(self, shaded: Shaded | None = None) -> None:
        clouds = self._drawn = self.clouds
        samples = {name: cloud.sample for name, cloud in clouds.items()}
        shading, self._residuals = shaded or self._shades_of_any()
        self._shaded = None
        self._viewport.show_clouds(samples, theme.line_colours(list(clouds)), shading)
        self.drawn.emit()

    def _shades_of_any(self) -> Shaded:
        try:
            return self._shades(self.colouring)
        except ValueError:  # another survey, without intensities or a result
            self.colouring = "line"
            return None, {}

    def _shades(self, colouring: Colouring) -> Shaded:
        """Colours of the lines' points, and of the sightings' where these have their own."""
        if colouring != "residual":
            return shading(colouring, self.clouds), {}
        project, survey = self._document.project, self._document.survey
        if project is None or survey is None:
            return None, {}
        return residual_shading(project, survey, self.clouds, reach=self._reach)

    def _draw_targets(self) -> None:
        if not self._lines_due.isActive():  # which they follow
            self._targets_due.start()

    def _put_targets(self) -> None:
        self._targets_due.stop()
        project = self._document.project
        targets = [] if project is None or self._document.survey is None else list(project.targets)
        if self.candidate is not None:
            targets = [t for t in targets if t.name != self.candidate.name] + [self.candidate]
        highlights, markers = [], []
        for target in targets:
            groups = self._points_by_line(target, "")
            for sighting in target.sightings:
                used = target.used and sighting.used
                colour = self._colour(target) if used else theme.UNUSED_COLOUR
                points = groups.get(sighting.line)
                if points is not None:
                    key = target.name, sighting.line
                    shades = self._residuals.get(key)
                    if shades is not None and len(shades) != len(points):
                        shades = None  # edited since the adjustment
                    highlights.append(Highlight(key, points, colour, shades))
            label = f"{target.name}?" if target is self.candidate else target.name
            markers.append(Marker(label, _centre(target, groups), self._colour(target)))
        self._viewport.show_highlights(highlights)
        self._viewport.show_markers(markers)

    def _points(self, target: Target, line: str) -> Array | None:
        groups = self._points_by_line(target, line)
        return np.concatenate(list(groups.values())) if groups else None

    def _points_by_line(self, target: Target, line: str) -> dict[str, Array]:
        clouds = self.clouds
        return {
            s.line: clouds[s.line][s.indices]
            for s in target.sightings
            if s.line in clouds and line in ("", s.line)
        }

    def _colour(self, target: Target):
        if target is self.candidate:
            return theme.CANDIDATE_COLOUR
        return theme.TARGET_COLOUR if target.role == "target" else theme.VALIDATION_COLOUR


def _centre(target: Target, groups: dict[str, Array]) -> tuple[float, float, float]:
    """Where the label of a target stands: amid its points of each line, or at its seed."""
    if not any(len(points) for points in groups.values()):
        return target.seed
    x, y, z = (float(v) for v in np.concatenate(list(groups.values())).mean(axis=0))
    return x, y, z


def _vessel(survey) -> tuple[float, float, float]:
    """Mean place of the vessel while it scanned: where a standard view looks from."""
    times = np.concatenate(
        [np.linspace(scan.first_time, scan.last_time, 21) for scan in survey.scans.values()]
    )
    north, west, up = (float(v) for v in survey.trajectory.at(times).position.mean(axis=0))
    return north, west, up
