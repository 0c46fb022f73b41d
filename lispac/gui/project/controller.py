"""Controller of the project: opening, saving, seeds and edits of the targets."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import dist
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal

from lispac.acceptance import NO_CRITERIA
from lispac.duplicate_targets import project_warnings
from lispac.errors import LispacError, ProjectChanged
from lispac.gui.app.questions import CandidateChoice
from lispac.gui.app.settings import AppSettings, documents_folder
from lispac.gui.app.tasks import Task, TaskRunner, preload_matplotlib
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.project.seed_options import SeedOptions
from lispac.gui.viewport.base import PickedPoint
from lispac.language import N_, Plural, Template, gettext
from lispac.messages import Message, error
from lispac.progress import Progress, sub_progress
from lispac.project import LineSource, Project, Settings, Target, Triple
from lispac.workflow.calibration import edits
from lispac.workflow.calibration.target_search import thinned_notes
from lispac.workflow.importing.input_files import ImportRequest
from lispac.workflow.project.attitude_signs import SignedAngle, with_reversed_signs
from lispac.workflow.project.survey import Survey, load_survey

OpenedProject = tuple[Project, Survey]
GEOREFERENCING_KEY = "survey"
"""Key of the task that georeferences the lines again after an edit."""
ESTIMATE_KEY = "estimate"
"""Key of the task that estimates the boresight."""
SETTINGS_EDIT_NAMES = {
    "lever_arm": N_("change of lever arm"),
    "boresight_deg": N_("change of prior boresight"),
    "lidar_sigma": N_("change of LiDAR noise"),
    "lidar_sigma_xyz": N_("change of LiDAR noise"),
    "lidar_beam_sigma": N_("change of LiDAR noise"),
}
"""Names of the undo steps of changed settings, by the name of the setting."""
REVERSED_SIGN_TEXTS: Mapping[tuple[SignedAngle, ...], tuple[Template, Template]] = {
    ("roll",): (
        N_("change of the sign of roll"),
        N_("The sign of roll was changed. Check the points of the targets, then estimate again."),
    ),
    ("pitch",): (
        N_("change of the sign of pitch"),
        N_("The sign of pitch was changed. Check the points of the targets, then estimate again."),
    ),
    ("roll", "pitch"): (
        N_("change of the signs of roll and pitch"),
        N_(
            "The signs of roll and pitch were changed. Check the points of the targets, then "
            "estimate again."
        ),
    ),
}
"""Name of the undo step and text for the log, by the angles whose signs were changed."""


@dataclass(frozen=True, eq=False)
class _QueuedSeed:
    """A clicked seed whose search waits for the running task.

    Attributes
    ----------
    find_position : function that returns the prior position of the point, when it was clicked
    """

    point: PickedPoint
    find_position: Callable[[], Triple]
    options: SeedOptions


class Controller(QObject):
    """Carries out the actions of the user on the project."""

    candidate_changed = Signal()
    accepted = Signal(str)
    """Name of the target that was just accepted."""
    logged = Signal(str)
    """A message for the log and the status bar."""
    refused = Signal(object)
    """An error to show to the user."""
    seed_refused = Signal(str)
    """Reason why a click was not taken as a seed."""
    files_missing = Signal(object)
    """A project that cannot be opened before its files are found."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        settings: AppSettings,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._runner, self._scene = document, runner, scene
        self._settings = settings
        self._task_of_project: tuple[Task, Project] | None = None
        self._search: tuple[Task, Triple, str] | None = None
        """Running search for a target: task, displayed seed and name of the target."""
        self._queued_seeds: list[_QueuedSeed] = []
        runner.progress_changed.connect(self._show_search)
        runner.stopped.connect(lambda _title: self._discard_queued_seeds())
        runner.idle.connect(self._search_next_seed)
        # Queued, since the accepted candidate is added to the project after this signal
        self.candidate_changed.connect(self._search_next_seed, Qt.ConnectionType.QueuedConnection)
        document.about_to_open.connect(self._discard_queued_seeds)
        self.candidate: Target | None = None
        self.may_save: Callable[[Project], bool] = lambda _project: True
        self.may_overwrite: Callable[[Project], bool] = lambda _project: False
        """Function that decides whether to overwrite a project that another program has changed."""
        document.changed.connect(self._on_document_changed)
        self._is_source_edited = False
        """Whether the user has typed or cleared the source of the acceptance criteria."""
        document.opened.connect(lambda: setattr(self, "_is_source_edited", False))

    @property
    def busy(self) -> bool:
        """Whether a task is running that the user waits for."""
        return self._runner.busy

    # -- open and save -----------------------------------------------------------------------

    def open(self, path: Path) -> None:
        """Open a project from its folder, its project.json or its .lispac file."""

        def read() -> tuple[Project, tuple[str, ...]]:
            from lispac.workflow.project.projects import open_project_with_notes

            return open_project_with_notes(path)

        self._open(path.name, read)

    def open_relocated(self, project: Project) -> None:
        """Open a project whose moved files were found, and mark it as modified."""
        self._open(project.name, lambda: (project, ()), files_were_moved=True)

    def _open(
        self,
        name: str,
        read: Callable[[], tuple[Project, tuple[Message, ...]]],
        *,
        files_were_moved: bool = False,
    ) -> None:
        def work(progress: Progress) -> OpenedProject | Project:
            from lispac.workflow.project.moved_files import missing_files

            project, notes = read()
            if missing_files(project):
                return project
            if project.validation:
                preload_matplotlib()
            _, survey = _load_lines(project, progress)
            return project, replace(survey, notes=(*notes, *survey.notes))

        def done(opened: OpenedProject | Project) -> None:
            if isinstance(opened, Project):
                self.files_missing.emit(opened)
                return
            self._show_opened_project(opened)
            if files_were_moved and self._document.project is opened[0]:
                self._document.undo_stack.resetClean()
                self.logged.emit(
                    gettext("The files were found. Save the project to keep their new location.")
                )

        self._runner.run(gettext("Opening {name}", name=name), work, done, modal=True)

    def create(self, request: ImportRequest) -> None:
        """Create a project from imported files and open it."""

        def work(progress: Progress) -> OpenedProject:
            from lispac.workflow.project.projects import new_project

            return new_project(
                request.folder,
                trajectory=request.trajectory,
                lines=request.lines,
                settings=request.settings,
                accuracy=request.accuracy,
                trajectory_reading=request.trajectory_reading,
                accuracy_reading=request.accuracy_reading,
                identity=request.identity,
                progress=progress,
            )

        title = gettext("Creating {name}", name=request.folder.name)
        self._runner.run(title, work, self._show_opened_project, persistent=True, modal=True)

    def add_lines(self, lines: Sequence[LineSource]) -> None:
        """Add lines to the project: one undo step."""
        project = self._document.project
        if project is None:
            return
        count, name = len(lines), lines[0].name

        def work(progress: Progress) -> OpenedProject:
            from lispac.workflow.project.projects import with_lines_added

            return with_lines_added(project, lines, progress=progress)

        def done(added: OpenedProject) -> None:
            edited, survey = added
            self._discard_candidate()  # it was found without the added lines
            edit = N_("addition of {line}") if count == 1 else N_("addition of {count:n} lines")
            self._document.edit(edit, edited, survey=survey, count=count, line=name)
            for note in survey.notes:
                self.logged.emit(message_text(note))
            if count == 1:
                template = N_("{line} was added to {project}. Save the project to keep it.")
            else:
                template = N_(
                    "{count:n} lines were added to {project}. Save the project to keep them."
                )
            self.logged.emit(gettext(template, count=count, line=name, project=project.name))

        template = N_("Adding {line}") if count == 1 else N_("Adding {count:n} lines")
        title = gettext(template, count=count, line=name)
        self.cancel_on_edit(self._runner.run(title, work, done))

    def open_demo(
        self, folder: Path | None = None, *, first: Callable[[], None] = lambda: None
    ) -> None:
        """Open the demo survey, which is simulated on its first use.

        ``first`` is called only after the demo was read, immediately before it is shown.
        """
        place = folder or demo_folder()

        def work(progress: Progress) -> OpenedProject:
            from lispac.workflow.planning.demo import make_demo
            from lispac.workflow.project.projects import open_project

            if (place / "project.json").is_file():
                project = open_project(place)
            else:
                project = make_demo(place, progress=sub_progress(progress, 0.0, 0.8))
            return _load_lines(project, sub_progress(progress, 0.8, 1.0))

        def done(opened: OpenedProject) -> None:
            first()
            self._show_opened_project(opened)

        self._runner.run(gettext("Opening the demo survey"), work, done, modal=True)

    def save(self) -> bool:
        """Save the project; return whether it was saved."""
        from lispac.workflow.project.projects import save_project

        project = self._document.project
        if project is None:
            return True
        if not self.may_save(project):
            return False
        try:
            try:
                saved = save_project(project, expected=self._document.file_digest)
            except ProjectChanged:
                if not self.may_overwrite(project):
                    return False
                saved = save_project(project)
        except LispacError as failure:
            self.refused.emit(type(failure)(error("window.not_saved", reason=failure.reason)))
            return False
        except OSError as failure:
            self.refused.emit(failure)
            return False
        self._document.mark_saved(saved.file_digest)
        self.logged.emit(gettext("Saved {project}", project=project.name))
        return True

    def save_as(self, folder: Path) -> None:
        """Save the project in another folder and continue there with the same undo steps."""
        project, survey = self._document.project, self._document.survey
        if project is None or survey is None:
            return

        def work(progress: Progress) -> OpenedProject:
            from lispac.workflow.project.project_copy import save_project_as

            return save_project_as(project, survey, folder, progress=progress)

        def done(saved: OpenedProject) -> None:
            saved_project, found = saved
            self._document.move(saved_project, found)
            self._settings.add_recent(saved_project.folder)
            self.logged.emit(
                gettext(
                    "Saved as {folder}. The project in {former} stays as it was last saved.",
                    folder=saved_project.folder,
                    former=project.folder,
                )
            )

        title = gettext("Saving as {name}", name=folder.name)
        self._runner.run(title, work, done, persistent=True)

    def _show_opened_project(self, opened: OpenedProject) -> None:
        project, survey = opened
        self._discard_candidate()
        self._document.open(project, survey)
        self._settings.add_recent(project.folder)
        if self._document.project is None:  # not opened, since another window has locked it
            return
        for note in survey.notes:
            self.logged.emit(message_text(note))
        self.logged.emit(gettext("Opened {folder}", folder=project.folder))

    def _on_document_changed(self) -> None:
        """Reload the data and cancel dependent tasks after a change of the project."""
        project = self._document.project
        if self._task_of_project is not None and self._task_of_project[1] is not project:
            self._task_of_project[0].cancel.set()
            self._task_of_project = None
        if project is None or self._document.is_survey_current:
            return
        self._discard_candidate()
        self._discard_queued_seeds()  # their positions are those of the former lines
        former = self._document.survey

        def done(survey: Survey) -> None:
            if self._document.project is not None:
                self._document.set_survey(project, survey)

        self._runner.run(
            gettext("Georeferencing the lines"),
            lambda progress: load_survey(project, former=former, progress=progress),
            done,
            key=GEOREFERENCING_KEY,
        )

    def cancel_on_edit(self, task: Task) -> None:
        """Cancel the task when the project is edited, as its result would be out of date."""
        assert self._document.project is not None
        self._task_of_project = (task, self._document.project)

    # -- seeds -------------------------------------------------------------------------------

    def seed(self, point: PickedPoint, seed_options: SeedOptions) -> None:
        """Search for the target at a clicked point and show it as the candidate.

        If the search is in one line only and a target is selected, the sighting is for that target,
        with its role and shape. The seed is marked and queued while another task runs, other seeds
        wait, or a candidate at another place waits; near a candidate it replaces the candidate.
        """
        if self._document.project is None:
            return
        if not self._document.is_survey_current:
            self.seed_refused.emit(
                gettext("The lines are being georeferenced. Pick the target again afterwards.")
            )
            return
        seed = _QueuedSeed(point, self._scene.prior_position_finder(point), seed_options)
        if self._runner.busy or self._queued_seeds or self._is_beyond_candidate(point.position):
            self._queued_seeds.append(seed)
            self._show_search()
            self.logged.emit(
                gettext(
                    Plural(
                        "{count:n} seed is waiting. Its search starts after the running task, "
                        "when the detected target is accepted or rejected.",
                        "{count:n} seeds are waiting. Their searches start after the running "
                        "task, when the detected target is accepted or rejected.",
                    ),
                    count=len(self._queued_seeds),
                )
            )
            return
        self._search_at_seed(seed)

    def _is_beyond_candidate(self, position: Triple) -> bool:
        """Whether a candidate waits and the position is farther away than its search radius."""
        candidate = self.candidate
        return candidate is not None and dist(candidate.seed, position) > candidate.radius

    def _search_at_seed(self, seed: "_QueuedSeed") -> None:
        self._search_target(
            seed.find_position, seed.point.position, seed.options, first_line=seed.point.line
        )

    def _search_next_seed(self) -> None:
        """Search at the first queued seed, unless a task runs or a candidate waits."""
        if not self._queued_seeds or self._runner.busy or self.candidate is not None:
            return
        if self._document.project is None or not self._document.is_survey_current:
            return
        self._search_at_seed(self._queued_seeds.pop(0))

    def _discard_queued_seeds(self) -> None:
        self._queued_seeds = []
        self._show_search()

    def search_at(self, position: Triple, seed_options: SeedOptions, *, name: str = "") -> None:
        """Search for the target at a position, and move the view to it if it is outside.

        An empty ``name`` stands for the selected target if only one line is searched, otherwise for
        the next free name.

        Parameters
        ----------
        position : metres, local frame
        """

        def show(candidate: Target) -> None:
            self.set_candidate(candidate)
            self._scene.bring_into_view(candidate)

        self._search_target(lambda: position, position, seed_options, name=name, show=show)

    def _search_target(
        self,
        position: Callable[[], Triple],
        shown: Triple,
        seed_options: SeedOptions,
        *,
        name: str = "",
        first_line: str | None = None,
        show: Callable[[Target], None] | None = None,
    ) -> None:
        project, survey = self._document.project, self._document.survey
        if project is None or survey is None or not self._document.is_survey_current:
            return
        from lispac.workflow.calibration import picking

        role, line = seed_options.role, seed_options.line
        arguments = seed_options.finder_arguments
        is_selected = any(each.name == seed_options.selected for each in project.targets)
        if line is not None and is_selected and not name:
            selected = project.target(seed_options.selected)
            name, role = selected.name, selected.role
            arguments |= {"shape": selected.shape, "sphere_radius": selected.sphere_radius}
        name = name or picking.next_name(project, role)

        def work(progress: Progress) -> Target:
            return picking.find_target(
                project, survey, position(), name=name, role=role, line=line, first_line=first_line,
                progress=progress, **arguments,
            )  # fmt: skip

        if line is None:
            title = gettext("Searching for {target} in all lines", target=name)
        else:
            title = gettext("Searching for {target} in {line}", target=name, line=line)
        task = self._runner.run(title, work, show or self.set_candidate)
        self._search = task, shown, name
        self.cancel_on_edit(task)
        self._show_search()

    def _show_search(self) -> None:
        """Mark the seed of the running search, with its progress, and the queued seeds."""
        marks: list[tuple[str, Triple]] = []
        if self._search is not None:
            task, seed, name = self._search
            if self._runner.is_unfinished(task):
                label = gettext("{target}: searching, {share:percent.0} %", target=name,
                                share=task.fraction)  # fmt: skip
                marks.append((label, seed))
            else:
                self._search = None
        waiting = gettext("waiting")
        marks += [(waiting, each.point.position) for each in self._queued_seeds]
        self._scene.show_searches(marks)

    def accept(self) -> None:
        """Add the candidate to the project as one undo step."""
        candidate, project = self.candidate, self._document.project
        if candidate is None or project is None:
            return
        self._discard_candidate()
        name, sightings = candidate.name, len(candidate.sightings)
        self._scene.select(name)  # a panel that opens now must not cover it
        self._document.edit(N_("addition of {target}"), project.with_target(candidate), target=name)
        found = Plural(
            "{target}: found in {sightings:n} of {count:n} line",
            "{target}: found in {sightings:n} of {count:n} lines",
        )
        self.logged.emit(gettext(found, target=name, sightings=sightings, count=len(project.lines)))
        self.accepted.emit(candidate.name)

    def reject(self) -> None:
        """Discard the candidate."""
        if self.candidate is not None:
            self.logged.emit(
                gettext("The detected target {target} was rejected.", target=self.candidate.name)
            )
            self._discard_candidate()

    def resolve_candidate(self, ask: Callable[[str], CandidateChoice]) -> bool:
        """Accept or reject a waiting candidate as the user answers; False if the user cancels."""
        if self.candidate is None:
            return True
        choice = ask(self.candidate.name)
        if choice == "accept":
            self.accept()
        elif choice == "reject":
            self.reject()
        return choice != "cancel"

    def set_candidate(self, candidate: Target) -> None:
        """Show a detected target, which the user then accepts or rejects."""
        self.candidate = candidate
        self._scene.show_candidate(candidate)
        for each in thinned_notes(candidate):
            self.logged.emit(message_text(each))
        self.candidate_changed.emit()

    def _discard_candidate(self) -> None:
        if self.candidate is not None:
            self.candidate = None
            self._scene.show_candidate(None)
            self.candidate_changed.emit()

    # -- edits -------------------------------------------------------------------------------

    def rename(self, old: str, new: str) -> bool:
        """Rename a target; return whether the name is accepted."""
        if self._project is None:
            return False
        try:
            edited = edits.with_renamed_target(self._project, old, new)
        except LispacError as error:
            self.refused.emit(error)
            self._document.changed.emit()
            return False
        self._document.edit(N_("renaming of {target}"), edited, recompute=True, target=old)
        return True

    def remove(self, name: str) -> None:
        """Remove a target."""
        if self._project is not None:
            edited = self._project.without_target(name)
            self._document.edit(N_("removal of {target}"), edited, target=name)

    def use_target(self, name: str, used: bool) -> None:
        """Include or exclude a target."""
        if self._project is not None:
            title = N_("inclusion of {target}") if used else N_("exclusion of {target}")
            edited = edits.set_target_use(self._project, name, used)
            self._document.edit(title, edited, recompute=True, target=name)

    def use_sighting(self, name: str, line: str, used: bool) -> None:
        """Include or exclude a sighting."""
        if self._project is not None:
            included = N_("inclusion of {target} in {line}")
            title = included if used else N_("exclusion of {target} in {line}")
            edited = edits.set_sighting_use(self._project, name, line, used)
            self._document.edit(title, edited, recompute=True, target=name, line=line)

    def use_line(self, line: str, used: bool) -> None:
        """Include or exclude all sightings of a line."""
        if self._project is not None:
            title = N_("inclusion of line {line}") if used else N_("exclusion of line {line}")
            edited = edits.set_line_use(self._project, line, used)
            self._document.edit(title, edited, recompute=True, line=line)

    def change_settings(self, settings: Settings) -> None:
        """Apply edited settings to the project: one undo step."""
        if self._project is None:
            return
        try:
            settings.require_sound()
        except LispacError as error:
            self.refused.emit(error)
            return
        if settings != self._project.settings:
            name = _settings_edit_name(self._project.settings, settings)
            self._document.edit(name, self._project.with_settings(settings))

    def reverse_signs(self, angles: tuple[SignedAngle, ...]) -> None:
        """Read the trajectory with the opposite signs of some angles: one undo step."""
        if self._project is not None and angles:
            name, text = REVERSED_SIGN_TEXTS[angles]
            self._document.edit(name, with_reversed_signs(self._project, angles))
            self.logged.emit(gettext(text))

    def change_acceptance(self, values: Mapping[str, float | str | None]) -> None:
        """Change acceptance criteria, given by their names: one undo step.

        With the first criterion, the contract in the details for the report becomes the source if
        there is none and the user has not cleared it.
        """
        if self._project is None:
            return
        former, contract = self._project.acceptance, self._project.identity.contract
        if "source" in values:
            self._is_source_edited = True
        elif former == NO_CRITERIA and contract and not self._is_source_edited:
            values = {**values, "source": contract}
        try:
            criteria = former.changed(**values)
        except LispacError as error:
            self.refused.emit(error)
            self._document.changed.emit()
            return
        if criteria != former:
            name = N_("change of acceptance criteria")
            self._document.edit(name, self._project.with_acceptance(criteria))

    @property
    def _project(self) -> Project | None:
        return self._document.project


def _settings_edit_name(before: Settings, after: Settings) -> Template:
    """Name of the undo step of a change of settings."""
    changed = [
        name for name in SETTINGS_EDIT_NAMES if getattr(before, name) != getattr(after, name)
    ]
    return SETTINGS_EDIT_NAMES[changed[0]] if changed else N_("change of adjustment settings")


def demo_folder() -> Path:
    """Folder of the demo survey, among the documents of the user."""
    return documents_folder() / "LISPAC demo"


def _load_lines(project: Project, progress: Progress) -> OpenedProject:
    """Load the lines of a project, and compute the warnings that are shown first."""
    survey = load_survey(project, progress=progress)
    project_warnings(project)
    return project, survey
