"""Checks of a plan, and files of a survey design."""

from collections.abc import Sequence
from pathlib import Path

from lispac.adjustment.diagnostics.observability import assess_observability
from lispac.adjustment.model.threads import single_blas_thread
from lispac.design.monte_carlo import MonteCarloResult, run_monte_carlo
from lispac.design.objective import CRITERION_TEXTS, PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import have_targets_one_orientation
from lispac.design.plan_search import DesignResult, Mapper
from lispac.design.prediction import UNDETERMINED_MESSAGE, predict, predicted_equations
from lispac.design.scenarios import ScenarioOutcome
from lispac.design.site import Site, clearance_from_wall, overlapping_targets
from lispac.errors import LispacError, RankDeficient, system_reason
from lispac.io.config.plan_file import TitledPlan, write_plan
from lispac.io.files import atomic_write, bad_name_error
from lispac.language import LazyText, gettext_lazy
from lispac.message_texts import message_text
from lispac.messages import Message, as_message, error, note, warning
from lispac.present.csv_text import keyed_csv_text
from lispac.present.planning.design_results import (
    SCENARIOS_CSV,
    SHORTER_PLANS_CSV,
    ScenarioValues,
    ShorterPlanPrecision,
)
from lispac.progress import Progress, no_progress

ONE_ORIENTATION_ERROR = error("plan_survey.one_orientation")
"""Error that all targets of a plan have the same orientation."""

MIN_WALL_DISTANCE = 3.0
"""Smallest distance at which a vessel can pass a wall safely, metres."""


def observability_messages(plan: Plan, *, progress: Progress = no_progress) -> tuple[Message, ...]:
    """Messages on the observability of the angles of a plan, as after an adjustment."""
    try:
        if have_targets_one_orientation(plan):
            return (ONE_ORIENTATION_ERROR,)
        if not predict(plan).determined:
            return (UNDETERMINED_MESSAGE,)
        with single_blas_thread():
            found = assess_observability(predicted_equations(plan), progress=progress)
            return (*found.messages, *_control_notes(plan))
    except RankDeficient as failure:
        return (as_message(failure.reason),)


def _control_notes(plan: Plan) -> tuple[Message, ...]:
    """Note on the effect of the surveyed control; none without control."""
    surveyed = tuple(target.name for target in plan.surveyed_targets)
    if not surveyed:
        return ()
    without = predict(plan.without_control())
    if not without.determined:
        return (note("plan_survey.control_needed", targets=surveyed),)
    roll, pitch, yaw = (float(each) for each in without.sigma)
    return (note("plan_survey.control_gain", targets=surveyed, roll=roll, pitch=pitch, yaw=yaw),)


def simulate_surveys(
    plan: Plan,
    surveys: int,
    *,
    seed: int,
    flatness_known: bool = False,
    enough: int | None = None,
    mapper: Mapper = map,
    progress: Progress = no_progress,
) -> MonteCarloResult:
    """Simulate and adjust many surveys of a plan; parameters as for `run_monte_carlo`.

    Raises
    ------
    RankDeficient
        As `run_monte_carlo`, and if all targets have the same orientation.
    """
    if have_targets_one_orientation(plan):
        raise RankDeficient(ONE_ORIENTATION_ERROR)
    return run_monte_carlo(
        plan, surveys, seed=seed, flatness_known=flatness_known, enough=enough, mapper=mapper,
        progress=progress,
    )  # fmt: skip


def result_heading(title: str, result: MonteCarloResult, count: int) -> LazyText:
    """Heading of the result of ``count`` simulated surveys."""
    done = len(result.errors) + result.failed
    if done < count:
        return gettext_lazy(
            "{title}: cancelled after {done:n} of {count:n} simulated surveys",
            title=title, done=done, count=count,
        )  # fmt: skip
    return gettext_lazy("{title}: {done:n} surveys simulated and adjusted", title=title, done=done)


def plan_warnings(titled: TitledPlan) -> tuple[Message, ...]:
    """Warnings about lines and targets of a plan that cannot be realised."""
    plan, found = titled.plan, []
    for k, off in enumerate(clearance_from_wall(plan, titled.wall), start=1):
        if off < 0:
            found.append(warning("plan.line_through_wall", line=k, distance=float(-off)))
        elif off < MIN_WALL_DISTANCE:
            found.append(warning("plan.line_near_wall", line=k, distance=float(off)))
    for one, other in overlapping_targets(plan.targets):
        found.append(warning("plan.targets_overlap", first=one, second=other))
    return tuple(found)


def write_field_plan(path: Path, titled: TitledPlan) -> None:
    """Write the plan on one page as PDF, for use in the field."""
    from lispac.report.field_plan import field_plan_figure

    texts = tuple(map(message_text, plan_warnings(titled)))
    page = field_plan_figure(titled.plan, titled.wall, titled.title, warnings=texts)
    with atomic_write(Path(path)) as temporary:
        page.savefig(temporary, format="pdf", metadata={"CreationDate": None})


def write_design(
    folder: Path, title: str, site: Site, design: DesignResult, objective: PlanObjective
) -> None:
    """Write the plan, its field plan and the Pareto front into a folder.

    Raises
    ------
    LispacError
        If the folder cannot be created.
    """
    from lispac.report.design_figures import pareto_front_figure

    folder = _create_folder(folder)
    titled = TitledPlan(title, design.plan, site.wall)
    write_plan(folder / "plan.toml", titled)
    write_field_plan(folder / "field-plan.pdf", titled)
    figure = pareto_front_figure(design.front, CRITERION_TEXTS[objective.criterion])
    with atomic_write(folder / "front.svg") as temporary:
        figure.savefig(temporary, format="svg", metadata={"Date": None})
    rows = [ShorterPlanPrecision.of(step) for step in design.front]
    with atomic_write(folder / "front.csv") as temporary:
        temporary.write_text(keyed_csv_text(SHORTER_PLANS_CSV, rows), encoding="utf-8", newline="")


def write_scenarios(folder: Path, outcomes: Sequence[ScenarioOutcome]) -> None:
    """Write the table of all outcomes and a plot of each scenario into a folder.

    Raises
    ------
    LispacError
        If the folder cannot be created.
    """
    from lispac.report.design_figures import scenario_figure

    folder = _create_folder(folder)
    rows = [ScenarioValues.of(each) for each in outcomes]
    with atomic_write(folder / "scenarios.csv") as temporary:
        temporary.write_text(keyed_csv_text(SCENARIOS_CSV, rows), encoding="utf-8", newline="")
    for scenario in dict.fromkeys(each.scenario for each in outcomes):
        figure = scenario_figure([each for each in outcomes if each.scenario == scenario])
        with atomic_write(folder / f"{scenario}.svg") as temporary:
            figure.savefig(temporary, format="svg", metadata={"Date": None})


def _create_folder(folder: Path) -> Path:
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except ValueError as failure:
        raise bad_name_error(folder) from failure
    except OSError as failure:
        raise LispacError(
            error(
                "plan_survey.folder_not_created",
                folder=str(folder),
                reason=system_reason(failure),
            )
        ) from failure
    return folder
