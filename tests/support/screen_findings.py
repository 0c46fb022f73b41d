"""Results shown in the dialogues of `tests.documents.screens`, computed once from the survey."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from lispac.gui.app.language import local_datetime
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.preferences.sensor_editor import NEW_POS, SensorEditor
from lispac.gui.window.dialogs import Dialogs
from lispac.identity import Identity
from lispac.io.project.project_file import write_project
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.subsampling import SubsamplingValues
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.project import Project
from lispac.simulation.thesis_site import SITES
from lispac.simulation.visibility_study import VisibilityStudy, study_visibility
from lispac.workflow.calibration.seed_lists import SeedOutcome, pick_seeds, read_seeds
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.checking.budget import error_budget_of
from lispac.workflow.checking.calibration_history import CalibrationHistory, read_histories
from lispac.workflow.checking.subsampling import (
    DEFAULT_DISTANCES,
    subsampling_study,
)
from lispac.workflow.project.survey import Survey
from tests.support.report_sample import sample_project

SYSTEM = Identity(vessel="Nordlys", scanner="VZ-400i")
SEARCH_TEXT = (
    "All are searched for as planes on every line, with search radius, threshold and the rest as "
    "set in step 2."
)
UNSAVED_TIME = 1772633100.0
"""Time at which unsaved work was stored, seconds since 1970."""
NOWHERE = (400.0, 400.0, 0.0)
"""A place without points on any line (north, west, up)."""


@dataclass(frozen=True)
class Findings:
    """Results of long computations."""

    checked: AbsoluteCheckValues
    budget: ErrorBudgetValues
    histories: tuple[tuple[CalibrationHistory, ...], tuple[str, ...]]
    subsampled: tuple[SubsamplingValues, ...]
    visible: list[VisibilityStudy]
    seeds: Path
    outcomes: tuple[SeedOutcome, ...]

    @classmethod
    def of(cls, project: Project, survey: Survey, folder: Path) -> "Findings":
        """Compute all results of an estimated and validated project; write files to a folder."""
        bare = project
        for target in project.targets:
            bare = bare.without_target(target.name)
        seeds = _seed_list(project, folder / "seeds.csv")
        listed = read_seeds(seeds, bare, survey.trajectory).seeds
        absolute = check_absolute(project, survey, _check_points(project, folder))[0].absolute
        assert absolute is not None
        return cls(
            AbsoluteCheckValues.of(absolute),
            ErrorBudgetValues.of(error_budget_of(project, survey)),
            _years(project, folder),
            subsampling_study(
                project, survey, sorted({*DEFAULT_DISTANCES, project.settings.subsample})
            ),
            [study_visibility(site) for site in SITES.values()],
            seeds,
            pick_seeds(bare, survey, listed, {})[1],
        )

    def dialogs_by_name(
        self, dialogs: Dialogs, settings: AppSettings, project: Project, survey: Survey
    ) -> dict[str, Callable[[], object]]:
        """Functions by name that open dialogues which no action opens directly."""
        way, used = survey.trajectory, project.settings.subsample
        return {
            "checked": lambda: dialogs.show_check_result(self.checked),
            "budget-found": lambda: dialogs.budget(self.budget),
            "history": lambda: dialogs.history(*self.histories),
            "subsampling": lambda: dialogs.subsampling(self.subsampled, used),
            "visibility": lambda: dialogs.visibility(self.visible),
            "seed-list": lambda: dialogs.seed_list(self.seeds, project, way, SEARCH_TEXT),
            "seeds-found": lambda: dialogs.seeds_found(self.outcomes, len(project.lines)),
            "sensors-of-plan": lambda: dialogs.sensors_of_plan(settings),
            "sensor-editor": lambda: SensorEditor(
                settings.sensors, NEW_POS, "", dialogs.parent
            ).exec(),
            "add-or-new": lambda: dialogs.ask_to_add(project.name),
            "candidate-waits": lambda: dialogs.ask_about_candidate("T3"),
            "recover": lambda: dialogs.ask_to_recover(project.name, local_datetime(UNSAVED_TIME)),
            "open-elsewhere": lambda: dialogs.ask_to_open_locked(
                project.name, "bridge, process 4711"
            ),
            "overwrite": lambda: dialogs.ask_to_overwrite(project.name),
        }


def _seed_list(project: Project, path: Path) -> Path:
    """Seeds of the targets of the project, and one at an empty place."""
    rows = [(target.name, *target.seed) for target in project.targets]
    rows.append(("T9", *NOWHERE))
    path.write_text("".join("{},{:.2f},{:.2f},{:.2f}\n".format(*row) for row in rows))
    return path


def _check_points(project: Project, folder: Path) -> Path:
    """The seeds as surveyed check points."""
    path = folder / "checkpoints.csv"
    path.write_text("".join("{},{},{},{}\n".format(t.name, *t.seed) for t in project.targets))
    return path


def _years(
    project: Project, folder: Path
) -> tuple[tuple[CalibrationHistory, ...], tuple[str, ...]]:
    """Results of the project in this year and in the previous year."""
    last = sample_project(folder / "years" / "2025")
    write_project(replace(last, identity=replace(SYSTEM, dates="2025-04-02")))
    now = replace(project, identity=replace(SYSTEM, dates="2026-04-05"))
    return read_histories([folder / "years"], also=[now])
