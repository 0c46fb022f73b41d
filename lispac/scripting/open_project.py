"""An open project, with the steps of the calibration as methods."""

from collections.abc import Collection, Sequence
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import numpy as np

from lispac.acceptance import Acceptance
from lispac.adjustment.result import AdjustmentResult
from lispac.control_points import (
    ControlFile,
    with_control_file,
    with_control_use,
    without_control_file,
)
from lispac.errors import ProjectError
from lispac.former_names import accept_script_names
from lispac.message_texts import message_text
from lispac.messages import as_message, error
from lispac.progress import Progress, no_progress
from lispac.project import BoresightChoice, LineSource, Project, Role, Shape, Target, Triple
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices
from lispac.targets.plane_finder import with_seed_position
from lispac.validation.absolute_check import AbsoluteCheck
from lispac.validation.local_models import DEFAULT_NEIGHBOURS, Kind, LocalModel
from lispac.validation.plane_comparison import PlaneComparison
from lispac.workflow.calibration import edits, picking
from lispac.workflow.calibration import estimation as calibration
from lispac.workflow.calibration.correspondences import CorrespondenceResult, correspondences
from lispac.workflow.calibration.proposal_acceptance import (
    remove_picked_surfaces,
    with_accepted_targets,
)
from lispac.workflow.calibration.proposals import Proposal, propose_targets
from lispac.workflow.calibration.seed_lists import SeedOutcome, pick_seeds, read_seeds
from lispac.workflow.checking import absolute_check, validation
from lispac.workflow.control import control_import
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.output.export import write_report
from lispac.workflow.output.export_request import FILE_TYPES, ExportContent, ExportRequest, export
from lispac.workflow.output.georeferencing import TrajectoryChoice
from lispac.workflow.output.installation import (
    format_of_path,
    project_replacement,
    write_installation,
)
from lispac.workflow.output.report_options import report_options
from lispac.workflow.output.script import script_of
from lispac.workflow.project import projects
from lispac.workflow.project.coordinates import require_near_trajectory
from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of
from lispac.workflow.project.project_copy import save_project_as
from lispac.workflow.project.survey import Survey, data_key, load_survey

AnyPath = str | Path


class OpenProject:
    """A project and its survey. Each step changes the project in memory; `save` writes it.

    A step that is not possible raises `lispac.LispacError` with the reason and changes nothing.

    Parameters
    ----------
    progress : callable
        Function that receives the progress of each step.

    Attributes
    ----------
    project : Project
        Present state of the project, an immutable value that each step replaces.
    """

    def __init__(
        self, project: Project, survey: Survey | None = None, *, progress: Progress = no_progress
    ) -> None:
        self.project = project
        self._survey = survey
        self._key = data_key(project)
        self._progress = progress

    def __repr__(self) -> str:
        targets = len(self.project.targets)
        return f"<lispac.{type(self).__name__} {self.project.name}: {targets} targets>"

    @property
    def survey(self) -> Survey:
        """Trajectory and lines, read on first access and after a change of data settings."""
        if self._survey is None or self._key != data_key(self.project):
            self._survey = load_survey(self.project, former=self._survey, progress=self._progress)
            self._key = data_key(self.project)
        return self._survey

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on assumptions and excluded data of the reading, as texts."""
        return tuple(map(message_text, self.survey.notes))

    @property
    def result(self) -> AdjustmentResult:
        """Result of the adjustment; angles in radians.

        Raises
        ------
        ProjectError
            If nothing has been estimated, or an edit has cleared the result since.
        """
        self.project.mounting("estimated")
        assert self.project.result is not None
        return self.project.result

    @property
    def boresight_deg(self) -> Triple:
        """Estimated roll, pitch, yaw in degrees."""
        roll, pitch, yaw = np.degrees(self.result.angles).tolist()
        return roll, pitch, yaw

    @property
    def sigma_deg(self) -> Triple:
        """Standard deviations of roll, pitch, yaw in degrees."""
        roll, pitch, yaw = np.degrees(self.result.sigma[:3]).tolist()
        return roll, pitch, yaw

    # -- data --------------------------------------------------------------------------------

    def add_lines(self, *lines: AnyPath | LineSource) -> None:
        """Add lines; targets and results are kept."""
        sources = [
            line if isinstance(line, LineSource) else LineSource(Path(line).stem, Path(line))
            for line in lines
        ]
        project, survey = projects.with_lines_added(self.project, sources, progress=self._progress)
        self.project, self._survey, self._key = project, survey, data_key(project)

    def import_lines(self, names: Sequence[str] = ()) -> None:
        """Store lines in the project's folder, ordered in space; all lines if none is named."""
        import_lines(self.project, names, progress=self._progress)
        self._survey = None

    @accept_script_names
    def change(self, **settings: object) -> None:
        """Change fields of `lispac.Settings`; dependent results have to be computed again."""
        changed = self.project.settings.with_values(**settings)
        changed.require_sound()
        if changed != self.project.settings:
            self.project = self.project.with_settings(changed)

    def identity(self, **texts: str) -> None:
        """Set the details for the report: fields of `lispac.Identity`."""
        self.project = self.project.with_identity(self.project.identity.changed(**texts))

    def acceptance(self, **criteria: float | str | None) -> Acceptance:
        """Set acceptance criteria, fields of `lispac.AcceptanceCriteria`, and judge by them."""
        self.project = self.project.with_acceptance(self.project.acceptance.changed(**criteria))
        return self.project.judgement

    # -- targets -----------------------------------------------------------------------------

    def seed(
        self,
        name: str,
        at: Sequence[float] | None = None,
        *,
        point: tuple[str, int] | None = None,
        role: Role = "target",
        shape: Shape = "plane",
        sphere_radius: float | None = None,
        line: str | None = None,
        clicked_on: str | None = None,
        threshold: float | None = None,
        radius: float | None = None,
        expected: ExpectedTarget | None = None,
        choices: FinderChoices = DEFAULT_CHOICES,
        crs: str = "",
        height: str = "",
        trajectory_datum: str | None = None,
        epoch: float | None = None,
    ) -> Target:
        """Find the target at a seed in every line and add it, as ``lispac pick`` does.

        Parameters
        ----------
        name : str
            Name of the target; a target with that name is replaced.
        at : three floats
            Seed: north, west, up in metres, or coordinates in ``crs``.
        point : (str, int)
            Alternative to ``at``: a line and the index of one of its points.
        role : {"target", "validation"}
        shape : {"plane", "sphere"}
        sphere_radius : float, metres, optional
            Radius of a sphere, if it is known.
        line : str, optional
            Only line to search.
        clicked_on : str, optional
            Line from which ``at`` was taken, if it is known.
        threshold, radius : metres, optional
            RANSAC distance threshold and search radius about the seed.
        expected : ExpectedTarget, optional
        choices : FinderChoices
            Finder options, for example the smallest number of points and the largest tilt.
        crs, height, trajectory_datum, epoch
            As the options of ``lispac pick``.

        Raises
        ------
        TargetNotFound
            If no line shows a target there.
        LispacError
            If the place or an option is not valid.
        ProjectError
            Unless exactly one of ``at`` and ``point`` is given.
        """
        survey = self.survey
        if (at is None) == (point is None):
            raise ProjectError(error("script.place_or_point", name=name))
        if point is not None:
            clicked_on, number = point
            place = picking.point_position(self.project, survey, clicked_on, number)
        else:
            system = output_system_of(
                self.project, survey.trajectory, crs or LOCAL_FRAME, height, trajectory_datum, epoch
            )
            place = require_near_trajectory(
                np.array(at, dtype=float), system, survey.trajectory, name
            )
        target = picking.find_target(
            self.project, survey, place, name=name, role=role, shape=shape,
            sphere_radius=sphere_radius, line=line, first_line=clicked_on, threshold=threshold,
            radius=radius, expected=expected, choices=choices, progress=self._progress,
        )  # fmt: skip
        self.project = self.project.with_target(target)
        return target

    def seeds(
        self,
        path: AnyPath,
        *,
        columns: Sequence[str] = (),
        role: Role | None = None,
        crs: str = "",
        height: str = "",
        trajectory_datum: str | None = None,
        epoch: float | None = None,
    ) -> tuple[SeedOutcome, ...]:
        """Pick all targets of a list of coordinates, as ``lispac pick --seeds`` does.

        Returns
        -------
        tuple of SeedOutcome
            For each row its ``target``, or the ``reason`` if none was found.
        """
        survey = self.survey
        system = output_system_of(
            self.project, survey.trajectory, crs or LOCAL_FRAME, height, trajectory_datum, epoch
        )
        listed = read_seeds(
            Path(path), self.project, survey.trajectory, system, columns=columns, role=role
        )
        self.project, outcomes = pick_seeds(
            self.project, survey, listed.seeds, {}, progress=self._progress
        )
        return outcomes

    def propose(self) -> Proposal:
        """Detect planes that could be used as targets, with reasons; `accept` adds them."""
        found = propose_targets(self.project, self.survey, progress=self._progress)
        return remove_picked_surfaces(self.project, found)

    def accept(self, proposal: Proposal, names: Collection[str] | None = None) -> tuple[str, ...]:
        """Add all or the named proposed targets; returns their names in the project."""
        accepted_names = [target.name for target in proposal.targets] if names is None else names
        self.project, new_names = with_accepted_targets(self.project, proposal, accepted_names)
        return new_names

    def put(self, target: Target) -> None:
        """Add a target with given points, or replace the target of that name."""
        # Scripts of earlier versions give the reasons as texts, or the seeds as north, west, up.
        reasons = {
            line: with_seed_position(as_message(reason)) for line, reason in target.missing.items()
        }
        target = replace(target, missing=reasons)
        picking.require_survey_points(self.survey, target)
        self.project = self.project.with_target(target)

    def reject(self, name: str, line: str | None = None) -> None:
        """Exclude a target, or one sighting of it."""
        self._set_use(name, line, False)

    def use(self, name: str, line: str | None = None) -> None:
        """Use a target, or one sighting of it, again; the inverse of `reject`."""
        self._set_use(name, line, True)

    def rename(self, old: str, new: str) -> None:
        """Give a target another name."""
        self.project = edits.with_renamed_target(self.project, old, new)

    def set_role(self, name: str, role: Role) -> None:
        """Make a target a validation plane, or a validation plane a target."""
        if self.project.target(name).role != role:
            self.project = edits.with_switched_role(self.project, name)

    def remove(self, name: str) -> None:
        """Remove a target or validation plane."""
        self.project = self.project.without_target(name)

    # -- control -----------------------------------------------------------------------------

    def control(
        self,
        path: AnyPath,
        *,
        sigma: float = control_import.DEFAULT_SIGMA,
        common_sigma: float | None = None,
        crs: str = "",
        height: str = "",
        trajectory_datum: str | None = None,
        epoch: float | None = None,
    ) -> ControlFile:
        """Import surveyed control for the adjustment, as ``lispac control`` does.

        Parameters
        ----------
        sigma : metres, standard deviation of points without one, or the common one of a scan
        common_sigma : metres, standard deviation of a translation that all points of the file share
        crs, height, trajectory_datum, epoch
            As the options of ``lispac control``.
        """
        self.project, _ = control_import.import_control(
            self.project, self.survey, Path(path), sigma=sigma, common_sigma=common_sigma, crs=crs,
            height=height, trajectory_datum=trajectory_datum, epoch=epoch, progress=self._progress,
        )  # fmt: skip
        return self.project.control[-1]

    def put_control(self, file: ControlFile) -> None:
        """Add control with given points, or replace the control of a file of that name."""
        file = replace(file, points=tuple(file.points))
        file.require_sound()
        self.project = self.project.with_control(with_control_file(self.project.control, file))

    def exclude_control(self, *names: str) -> None:
        """Exclude control points from the adjustment."""
        control = with_control_use(self.project.control, names, used=False)
        self.project = self.project.with_control(control)

    def use_control(self, *names: str) -> None:
        """Use control points again; the inverse of `exclude_control`."""
        control = with_control_use(self.project.control, names, used=True)
        self.project = self.project.with_control(control)

    def remove_control(self, name: str) -> None:
        """Remove the control of a file, by the name of the file."""
        control = without_control_file(self.project.control, name)
        self.project = self.project.with_control(control)

    # -- numbers -----------------------------------------------------------------------------

    def estimate(self, *, cross_check: bool = True) -> AdjustmentResult:
        """Adjust the boresight; with ``cross_check``, also from parts of the data."""
        self.project = calibration.estimate(
            self.project, self.survey, cross_check=cross_check, progress=self._progress
        )
        return self.result

    def validate(
        self,
        distance_to: Kind = "plane",
        *,
        neighbours: int | None = None,
        radius: float | None = None,
    ) -> tuple[PlaneComparison, ...]:
        """Compare the lines on the validation planes, with the prior and the estimated boresight.

        Parameters
        ----------
        distance_to : {"point", "plane", "quadric"}
            Local model of the surface to which distances are measured.
        neighbours : int, optional
            Number of points to which the plane (default 40) or quadric (60) is fitted.
        radius : metres, optional
            Radius within which all points are used instead of ``neighbours``.
        """
        usual = DEFAULT_NEIGHBOURS.get(distance_to, 1)
        model = LocalModel(distance_to, usual if neighbours is None else neighbours, radius)
        self.project = validation.validate(
            self.project, self.survey, model=model, progress=self._progress
        )
        return self.project.validation

    @accept_script_names
    def check(
        self,
        reference: AnyPath,
        *,
        sigma: float = absolute_check.DEFAULT_SIGMA,
        search_distance: float = absolute_check.SEARCH_DISTANCE,
        crs: str = "",
        height: str = "",
        trajectory_datum: str | None = None,
        epoch: float | None = None,
    ) -> AbsoluteCheck:
        """Compare the lines with a static scan or surveyed points, as ``lispac check`` does.

        Parameters
        ----------
        sigma : metres, standard deviation of the reference
        search_distance : metres, largest distance of line points from the reference
        """
        self.project, _ = absolute_check.check_absolute(
            self.project, self.survey, Path(reference), crs=crs, height=height,
            trajectory_datum=trajectory_datum, epoch=epoch, sigma=sigma,
            search_distance=search_distance,
            progress=self._progress,
        )  # fmt: skip
        assert self.project.absolute is not None
        return self.project.absolute

    # -- files -------------------------------------------------------------------------------

    def correspondences(
        self, file: AnyPath, *, time_shift: float = 0.0, noise: float | None = None
    ) -> CorrespondenceResult:
        """Estimate the boresight from pairs of points of the same place, for comparison.

        The result is kept in the project beside that of the targets.

        Parameters
        ----------
        file : path
            Text file with ``t_i t_j x_i y_i z_i x_j y_j z_j`` in each row: seconds, and metres in
            the frame of the raw lines.
        time_shift : float, seconds
            Added to the times of the file.
        noise : float, metres, optional
            Standard deviation of a coordinate difference of a pair; estimated by default.

        Raises
        ------
        InputError
            If the file cannot be read, or many of its times are outside the trajectory.
        AdjustmentError
            If the pairs are too few or wrong, or do not determine the boresight.
        """
        found = correspondences(
            self.project, self.survey, Path(file), time_shift=time_shift, noise=noise
        )
        self.project = self.project.with_alternative_result(found.alternative)
        return found

    def report(
        self,
        path: AnyPath,
        *,
        template: AnyPath | None = None,
        page: str = "",
        convention: str = "",
        language: str = "",
        extent: str = "",
        generated: datetime | None = None,
    ) -> None:
        """Write the report: .pdf, .html, .json, or .zip for all tables as CSV.

        Parameters
        ----------
        template, page, convention, language
            As the options of ``lispac report``.
        extent
            ``"short"`` or ``"full"``; by default, that of the template, or the short report.
        generated : date and time given in the report; now by default
        """
        options = report_options(
            None if template is None else Path(template), page, convention, language, extent
        )
        write_report(
            self.project, self.survey, Path(path), options=options, generated=generated,
            progress=self._progress,
        )  # fmt: skip

    def export(
        self,
        what: ExportContent,
        output: AnyPath,
        *,
        boresight: BoresightChoice = "estimated",
        form: str = "",
        crs: str = "",
        height: str = "",
        trajectory_datum: str | None = None,
        epoch: float | None = None,
        trajectory: TrajectoryChoice = "given",
    ) -> list[Path]:
        """Write lines, targets or planes to a folder, or a trajectory to a file.

        Parameters
        ----------
        what : {"lines", "targets", "planes", "trajectory", "corrected_trajectory"}
            With the corrected trajectory, its accuracies and corrections are written beside it.
        boresight : {"estimated", "prior"}
        form : str
            ``laz`` or ``las`` for lines; also ``csv`` for targets; ``sbet`` or ``text`` for the
            trajectory. The first of these by default.
        crs, height, trajectory_datum, epoch
            As the options of ``lispac export`` and ``lispac georeference``.
        trajectory : {"given", "corrected"}
            Trajectory with which lines are georeferenced.

        Raises
        ------
        ProjectError
            If ``what`` or ``form`` is not valid, or the trajectory cannot be corrected.
        """
        if what not in FILE_TYPES:
            raise ProjectError(error("script.unknown_export", what=what, known=list(FILE_TYPES)))
        if form and form not in FILE_TYPES[what]:
            raise ProjectError(
                error("script.unknown_export_format", what=what, form=form, forms=FILE_TYPES[what])
            )
        # By default, lines keep their system, and everything else is in the local frame.
        system = crs if what == "lines" else crs or LOCAL_FRAME
        request = ExportRequest(
            what, Path(output), boresight, form or FILE_TYPES[what][0], system, height,
            trajectory_datum, epoch, trajectory,
        )  # fmt: skip
        paths, _ = export(self.project, self.survey, request, progress=self._progress)
        return paths

    def save_installation(
        self, program: str, path: AnyPath, *, trajectory: AnyPath | None = None
    ) -> tuple[str, ...]:
        """Write the estimated boresight and the lever arm into a file for another program.

        Parameters
        ----------
        program : str
            As ``--to`` of ``lispac angles``.
        path : str or Path
            .json for ``pdal``, .kfc for ``kluster``; .txt for the values to enter in any program.
        trajectory : str or Path, optional
            SBET for a pipeline of ``pdal`` that georeferences the points.

        Returns
        -------
        tuple of str
            Notes on the file.
        """
        new, sigma_warning = project_replacement(self.project, program)
        form = format_of_path(
            Path(path), new.in_system.setup.convention, with_trajectory=trajectory is not None
        )
        notes = write_installation(
            Path(path), new, form, trajectory=None if trajectory is None else Path(trajectory),
            sigma_warning=sigma_warning, project=self.project,
        )  # fmt: skip
        return tuple(map(message_text, notes))

    def script(self) -> str:
        """Python script that makes this project from its raw files.

        Takes as long as picking the targets and estimating, because the script is tested.
        """
        return script_of(self.project, self.survey, progress=self._progress).text

    def save(self) -> None:
        """Write the project into its folder.

        Raises
        ------
        ProjectError
            If another program has changed the project since it was opened, or is changing it.
        """
        self.project = projects.save_project(self.project, expected=self.project.file_digest)

    def save_as(self, folder: AnyPath) -> None:
        """Write the project with its imported lines into another folder, and continue there."""
        project, survey = save_project_as(
            self.project, self.survey, Path(folder), progress=self._progress
        )
        self.project, self._survey, self._key = project, survey, data_key(project)

    def _set_use(self, name: str, line: str | None, used: bool) -> None:
        if line is None:
            self.project = edits.set_target_use(self.project, name, used)
            return
        if self.project.target(name).sighting(line) is None:
            raise ProjectError(error("script.no_sighting", target=name, line=line))
        self.project = edits.set_sighting_use(self.project, name, line, used)
