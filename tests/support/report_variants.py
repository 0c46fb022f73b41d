"""Variants of the sample report, with notes and messages of the program."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from lispac.adjustment.model.parameters import ParameterEstimate, mounting_value_name
from lispac.adjustment.model.robust_loss import LOSS_NAMES
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import VarianceComponent
from lispac.io.formats import POINT_FORMATS
from lispac.messages import Message, error, note
from lispac.project import Project
from lispac.report.content import ReportContent
from lispac.survey.georeferencing import Mounting
from tests.present.test_consistent_warnings import CASES
from tests.support.report_sample import LARGEST_INCREASES, sample_content

COMMENT_MARKS = (
    note(
        "observability.directions",
        weakest=note(
            "adjustment.angle_with_two",
            first=mounting_value_name("yaw"),
            second=mounting_value_name("roll"),
            third=mounting_value_name("pitch"),
        ),
        weakest_sigma=6.6e-4,
        strongest=mounting_value_name("roll"),
        strongest_sigma=2.8e-4,
    ),
    note(
        "observability.main_lines",
        count=1,
        lines=["L3"],
        angle=mounting_value_name("pitch"),
        line="L3",
        without=7.0e-4,
        sigma=5.1e-4,
    ),
    LARGEST_INCREASES,
)
"""Messages as made by `lispac.adjustment.diagnostics.observability`."""
NOTES = (
    note("trajectory.metres_assumed", file="a.txt", column="Alt"),
    note("assumed.column_unit", column="Alt", unit=note("unit.feet")),
    *(note("assumed.format", file="L3.laz", format=format.name) for format in POINT_FORMATS),
    note("assumed.same_time_base_shifted"),
    note("assumed.time_shift", file="L1.laz", shift=18.0),
    note("import.excluded_outside", file="L2.laz", count=12, total=1_234_567),
)

STEEP = Mounting.with_nearest_axes(np.array([-0.2, 0.04, 2.4]), np.radians([20.0, 89.3, 58.2]))
Change = Callable[[Project], Project]


def with_result(**values: Any) -> Change:
    def change(project: Project) -> Project:
        assert project.result is not None
        return replace(project, result=replace(project.result, **values))

    return change


def with_settings(**values: Any) -> Change:
    return lambda project: replace(project, settings=replace(project.settings, **values))


def _chi_square(factor: float, *, thesis: bool = False) -> Change:
    def change(project: Project) -> Project:
        assert project.result is not None
        test = project.result.chi_square
        model = StochasticModel("independent") if thesis else project.result.model
        test = replace(test, statistic=test.upper * factor)
        return with_result(chi_square=test, model=model)(project)

    return change


def _few_lines(project: Project) -> Project:
    first, second, third, fourth, fifth = project.targets
    reason = note(
        "finder.few_points",
        count=12, radius=1.0, needed=50,
        place=note("finder.seed_position", east=14.7, north=0.6, up=5.1),
    )  # fmt: skip
    return replace(
        project,
        targets=(
            replace(first, sightings=first.sightings[:1], missing={"L2": reason, "L3": reason}),
            replace(second, sightings=second.sightings[:2]),
            replace(third, sightings=()),
            replace(fourth, used=False),
            replace(fifth, missing={"L4": note("finder.line_no_points", radius=4.5)}),
        ),
    )


def _parameters(project: Project) -> Project:
    assert project.result is not None
    reason = note(
        "parameter.rotates_like_boresight",
        parameter=mounting_value_name("scan_angle_offset"), kept=note("parameter.kept"),
    )  # fmt: skip
    unseen = ParameterEstimate("scan_angle_offset", 0.0, None, reason=reason)
    late = ParameterEstimate("latency", 0.0, 0.002, 0.0011, 0.0008, 0.6)
    far = ParameterEstimate("range_offset", 0.0, 0.002, 0.0051, 0.0008, None)
    return with_result(parameters=(*project.result.parameters, unseen, late, far))(project)


def _worse(project: Project) -> Project:
    first, *rest = project.validation
    turned = replace(first, before=first.after, after=first.before, pooled_from="all pairs")
    refused = note("finder.unknown_line", line="L1")
    return replace(project, validation=(turned, *rest), not_compared={"V2": refused})


def _components(project: Project) -> Project:
    found = (
        VarianceComponent("LiDAR", 0.82, 0.78, 0.87, applied=True),
        VarianceComponent("POS position", 1.3, 0.6, 2.9, applied=True),
        VarianceComponent("POS attitude", 1.3, 0.1, 2.9),
    )
    return with_result(components=found, excluded_outliers=1)(project)


VARIANTS: dict[str, Change] = {
    "as it is": lambda project: project,
    "not calibrated": lambda p: replace(p, result=None, validation=(), cross_checks=None),
    "nothing picked": lambda p: replace(p, result=None, validation=(), targets=()),
    "not checked": lambda p: replace(p, cross_checks=None, validation=()),
    "simulated": lambda p: replace(p, truth_deg=(0.44, -1.87, 0.6)),
    "few lines": _few_lines,
    "parameters": _parameters,
    "worse": _worse,
    "components": _components,
    "steep pitch": with_result(mounting=STEEP),
    "thesis": with_result(model=StochasticModel("independent"), reliability=(), surface=0.0),
    "chi-square high": _chi_square(1.1),
    "chi-square high, thesis": _chi_square(1.1, thesis=True),
    "chi-square low": _chi_square(0.5),
    "no redundancy": with_result(degrees_of_freedom=0, variance_factor=float("nan")),
    "by beam": with_settings(lidar_beam_sigma=(0.006, 0.02), range_offset=0.012, latency=0.001),
    "by axis": with_settings(lidar_sigma_xyz=(0.003, 0.004, 0.005), scan_angle_offset_deg=0.1),
    "typed": lambda p: replace(
        with_settings(subsample=0.0, accept_single_orientation=True)(p), accuracy=None
    ),
    "origin": with_settings(origin_deg_m=(45.5, -73.5, -25.6)),
    "file gone": lambda p: replace(p, trajectory=p.folder / "gone.sbet"),
    **{loss: with_result(model=StochasticModel(loss=loss)) for loss in LOSS_NAMES},
    **{f"{code} {k}": change for k, (code, _, change, _) in enumerate(CASES)},
}


def content_of_sample(project: Project) -> ReportContent:
    """Report content of the sample, with notes and messages of the program."""
    result = project.result
    if result is not None and result.observability is not None:
        observability = replace(result.observability, messages=COMMENT_MARKS)
        parts = tuple(
            replace(p, reason=p.reason and note("cross_check.no_common_target"))
            if p.kind != "half"
            else replace(p, boresight=None, reason=_refusal_message())
            for p in (project.cross_checks.parts if project.cross_checks else ())
        )
        checks = project.cross_checks and replace(project.cross_checks, parts=parts)
        project = replace(
            project, result=replace(result, observability=observability), cross_checks=checks
        )
    return replace(sample_content(project), notes=NOTES)


def _refusal_message() -> Message:
    return error(
        "adjustment.undetermined_because",
        direction=note(
            "adjustment.angle_with_one",
            first=mounting_value_name("yaw"),
            second=mounting_value_name("roll"),
        ),
        reason=note("adjustment.parallel_lines_one_target", target="T1"),
        action=note("adjustment.add_orientation"),
    )
