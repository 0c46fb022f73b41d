"""Pictures for the report: defined views of the lines before and after the calibration."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QImage

from lispac.acceptance import planes_to_show
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance import theme, units
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import PriorOrEstimated, Scene
from lispac.gui.viewport.base import Array, Marker, Viewport
from lispac.gui.viewport.clipping import Box
from lispac.gui.viewport.overlay import AXES_PX, MARGIN_PX
from lispac.language import N_, LazyText, gettext, gettext_lazy, in_language
from lispac.project import Project, Target
from lispac.report.options import Extent, ReportOptions
from lispac.report.short_report import MAX_PICTURED_PLANES
from lispac.survey.cloud import Cloud
from lispac.targets.cross_section import common_normal

PICTURE_SIZE_PX = (1000, 700)
LABEL_SCALE, SMALL_LABEL_SCALE = 1.5, 2.2
"""Size of the labels relative to that on the screen, in pictures of half and of a third of the
width of the page; they are 6.5 points high in print."""
FIT_FACTOR = 1.12
"""Factor of the distance at which a picture shows its points: some single points are outside."""
BOX_MARGIN_M = 0.3
"""Distance of the clip box from the points of a target, metres."""
OBLIQUE_ANGLE_DEG = 60.0
"""Angle between the view of a surface and its normal: the surface has half of its width, and lines
that are shifted along the normal are seen apart."""

Pictures = dict[LazyText, QImage]
"""Pictures by their captions; before and after alternate."""
Step = Callable[[], None]


@dataclass(frozen=True, eq=False)
class _View:
    """View of which a picture before and one after are taken.

    Attributes
    ----------
    captions : captions of the two pictures
    targets : targets with a label
    points : points (n, 3) of a target before and after the calibration; None for all lines
    normal : normal of the target (3,); None for all lines
    label_scale : size of the labels relative to that on the screen
    """

    captions: Mapping[PriorOrEstimated, LazyText]
    targets: tuple[Target, ...]
    points: Array | None = None
    normal: Array | None = None
    label_scale: float = LABEL_SCALE

    def show(self, viewport: Viewport) -> None:
        """Move the camera; a surface is seen obliquely. Axes and scale bar cover no points."""
        viewport.set_fit_margins(self.label_scale * (AXES_PX + MARGIN_PX), FIT_FACTOR)
        if self.points is None or self.normal is None:
            viewport.clip(None)
            viewport.set_parallel(False)
            viewport.view("isometric")
            return
        box = Box.around(self.points, self.normal, BOX_MARGIN_M)
        viewport.clip(box)
        viewport.set_parallel(True)
        viewport.view_along(oblique_direction(self.normal), box.corners)


class ReportPictures(QObject):
    """Takes pictures in a viewport of its own, so that the view of the window is unchanged."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        scene: Scene,
        viewport: Viewport,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._runner, self._controller = document, runner, controller
        self._scene, self._window_viewport = scene, viewport
        self._viewport: Viewport | None = None
        for ended in (runner.stopped, runner.idle):
            ended.connect(self._close_viewport)

    def capture(
        self, project: Project, options: ReportOptions, then: Callable[[Pictures], None]
    ) -> None:
        """Take the pictures in the language of the report and call ``then`` with them.

        The lines must already be georeferenced with both boresights. Each picture is taken in two
        steps of the event loop, so that the window stays responsive. An edit of the project or a
        cancellation ends the process.
        """
        with theme.paper_colours():
            viewport = self._viewport = self._window_viewport.create_empty_viewport()
            viewport.show_line_legend(False)  # the report explains the colours once
            viewport.widget.setAttribute(Qt.WidgetAttribute.WA_DontShowOnScreen)
            viewport.widget.resize(*PICTURE_SIZE_PX)
            viewport.widget.show()
        views = list(_views(project, options.extent, self._clouds))
        taken: dict[tuple[PriorOrEstimated, int], QImage] = {}
        steps = list(self._steps(viewport, views, options.language, taken))

        def step(_nothing: None) -> None:
            with theme.paper_colours():
                steps.pop(0)()
            if self._document.project is not project:
                self._close_viewport()
            elif steps:
                self._run_step(step)
            else:
                self._close_viewport()
                then({
                    caption: taken[which, k]
                    for k, view in enumerate(views) for which, caption in view.captions.items()
                })  # fmt: skip

        self._run_step(step)

    def _steps(
        self,
        viewport: Viewport,
        views: list[_View],
        language: str,
        taken: dict[tuple[PriorOrEstimated, int], QImage],
    ) -> Iterator[Step]:
        def draw(which: PriorOrEstimated) -> None:
            clouds = self._clouds(which)
            samples = {name: cloud.sample for name, cloud in clouds.items()}
            viewport.show_clouds(samples, theme.line_colours(list(clouds)))

        def prepare(which: PriorOrEstimated, view: _View) -> None:
            # A label is at points of this picture: the lines are elsewhere in the other one.
            clouds = self._clouds(which)
            viewport.show_markers(
                [Marker(x.name, _labelled_point(x, clouds), _colour(x)) for x in view.targets]
            )
            view.show(viewport)
            viewport.prepare()

        def take(which: PriorOrEstimated, k: int) -> None:
            with units.standard_units(), in_language(language):
                taken[which, k] = viewport.picture(views[k].label_scale)

        order: tuple[PriorOrEstimated, ...] = ("prior", "estimated")
        for which in order:
            yield lambda which=which: draw(which)
            for k, view in enumerate(views):
                yield lambda which=which, view=view: prepare(which, view)
                yield lambda which=which, k=k: take(which, k)

    def _run_step(self, step: Callable[[None], None]) -> None:
        task = self._runner.run(
            gettext("Taking pictures of the view"), lambda _progress: None, step
        )
        self._controller.cancel_on_edit(task)

    def _clouds(self, which: PriorOrEstimated) -> Mapping[str, Cloud]:
        return self._scene.clouds_of(which)

    def _close_viewport(self) -> None:
        if self._viewport is not None:
            viewport, self._viewport = self._viewport, None
            viewport.close()
            viewport.widget.deleteLater()


def _views(
    project: Project,
    extent: Extent,
    clouds: Callable[[PriorOrEstimated], Mapping[str, Cloud]],
) -> Iterator[_View]:
    """The whole survey, each target (full report), and each validation plane.

    In the view of a surface only its own label is shown: other points in the box may be hidden, and
    their labels would be beside their surfaces.

    A short report has only some of the validation planes; see `planes_to_show`.
    """
    yield _View(
        {
            "prior": gettext_lazy("Overview, before the calibration"),
            "estimated": gettext_lazy("Overview, after the calibration"),
        },
        project.targets,
    )
    rms = {plane.name: plane.after.rms for plane in project.validation}
    failed = {name for name in rms if project.judgement.verdict_on(name) == "fail"}
    kept = planes_to_show(rms, failed, MAX_PICTURED_PLANES if extent == "short" else len(rms))
    for target in project.targets:
        if not (target.name in kept or (extent == "full" and target.role == "target")):
            continue
        placed = [_groups(target, clouds("prior")), _groups(target, clouds("estimated"))]
        if not all(placed):
            continue
        yield _View(
            {
                which: gettext_lazy(text, name=target.name, angle=round(OBLIQUE_ANGLE_DEG))
                for which, text in _captions_of(target).items()
            },
            (target,),
            np.concatenate([points for groups in placed for points in groups]),
            common_normal(placed[1]),
            SMALL_LABEL_SCALE if extent == "short" else LABEL_SCALE,
        )


def _captions_of(target: Target) -> Mapping[PriorOrEstimated, str]:
    if target.shape == "sphere":  # seen from any side, it looks the same
        return {
            "prior": N_("{name}, before the calibration"),
            "estimated": N_("{name}, after the calibration"),
        }
    return {
        "prior": N_("{name} seen at {angle}° to its normal, before the calibration"),
        "estimated": N_("{name} seen at {angle}° to its normal, after the calibration"),
    }


def oblique_direction(normal: Array) -> Array:
    """Direction at `OBLIQUE_ANGLE_DEG` to a normal (3,), turned towards the horizontal."""
    level = np.cross(normal, [0.0, 0.0, 1.0])
    length = np.linalg.norm(level)
    along = level / length if length > 1e-6 else np.array([1.0, 0.0, 0.0])
    angle = np.radians(OBLIQUE_ANGLE_DEG)
    return np.cos(angle) * normal / np.linalg.norm(normal) + np.sin(angle) * along


def _groups(target: Target, clouds: Mapping[str, Cloud]) -> list[Array]:
    """Points (n, 3) of a target on each line."""
    return [
        clouds[each.line][each.indices]
        for each in target.sightings
        if each.line in clouds and len(each.indices) >= 3
    ]


def _labelled_point(target: Target, clouds: Mapping[str, Cloud]) -> tuple[float, float, float]:
    """Point of a target nearest to the mean of its points, where its label is.

    The mean may be beside the surface, for instance of a sphere. Without points, it is the seed,
    which may be far from them.
    """
    groups = _groups(target, clouds)
    if not groups:
        return target.seed
    points = np.concatenate(groups)
    nearest = int(np.argmin(np.square(points - points.mean(axis=0)).sum(axis=1)))
    north, west, up = points[nearest].tolist()
    return north, west, up


def _colour(target: Target):
    return theme.TARGET_COLOUR if target.role == "target" else theme.VALIDATION_COLOUR
