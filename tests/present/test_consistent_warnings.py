"""Tests that the command line, the window and the report give the same warnings."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

from lispac.adjustment.diagnostics.excess_scatter import with_raised_sigmas
from lispac.adjustment.diagnostics.findings import exceedance_limit
from lispac.adjustment.diagnostics.warnings import WARNING_RULES, result_warnings
from lispac.adjustment.model.parameters import ParameterEstimate
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import (
    SIGMA_GROUPS,
    CommonCoverage,
    ContradictedParameter,
    RadiusDiscrepancy,
    UncontrolledObservations,
    VarianceComponent,
)
from lispac.cli.calibration.result_output import adjustment_output, print_result
from lispac.gui.appearance import theme
from lispac.gui.features.estimate import result_texts
from lispac.io.project.project_file import read_project, write_project
from lispac.language import in_language, to_plain_text
from lispac.message_texts import message_text
from lispac.messages import Level, Message, note
from lispac.present.calibration.adjustment import (
    AGREE_ESTIMATED_TEXT,
    AGREE_TEXT,
    NOT_JUDGED_TEXT,
    agreement_template,
)
from lispac.present.json_values import json_values
from lispac.project import Project
from lispac.survey.georeferencing import Mounting
from tests.support.control_sample import with_control
from tests.support.report_sample import sample_content, sample_project


def _steep(project: Project) -> Project:
    assert project.result is not None
    mounting = Mounting.with_nearest_axes(
        project.result.mounting.lever_arm, np.radians([0.0, -90.0, 0.0])
    )
    return replace(project, result=replace(project.result, mounting=mounting))


def _wide(project: Project) -> Project:
    """Roll has a standard deviation of half a degree."""
    assert project.result is not None
    covariance = project.result.covariance_all.copy()
    covariance[0] *= 30.0
    covariance[:, 0] *= 30.0
    return replace(project, result=replace(project.result, covariance_all=covariance))


def _lever_arm_changed(project: Project) -> Project:
    assert project.result is not None
    lever_z = ParameterEstimate("lever_z", -2.419, None, 2.419, 0.01)
    return replace(project, result=replace(project.result, parameters=(lever_z,)))


def _unseen(project: Project) -> Project:
    turned = ParameterEstimate(
        "scan_angle_offset", 0.0, 0.01, reason=note("parameter.kept_uncertain")
    )
    wide = _wide(project)
    assert wide.result is not None
    return replace(wide, result=replace(wide.result, parameters=(turned,)))


def _unchecked(
    kind: str, *, lines: int = 0, of_target: bool = False, angles: tuple[str, ...] = (),
    size: float = 0.0,
) -> Callable[[Project], Project]:  # fmt: skip
    def change(project: Project) -> Project:
        assert project.result is not None
        assert project.result.observability is not None
        target = project.targets[0].name if of_target else ""
        found = tuple(
            UncontrolledObservations(kind, target, name, angles, size)
            for name in [line.name for line in project.lines[:lines]] or [""]
        )
        observability = replace(project.result.observability, unchecked=found)
        return replace(project, result=replace(project.result, observability=observability))

    return change


def _excluded(project: Project) -> Project:
    assert project.result is not None
    names = tuple(target.name for target in project.targets[:2])
    return replace(project, result=replace(project.result, excluded_targets=names))


def _cut(share: float) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        lines = tuple(line.name for line in project.lines[:2]) if share else ()
        part = CommonCoverage(project.targets[0].name, share, lines)
        return replace(project, result=replace(project.result, common_parts=(part,)))

    return change


def _radii(cause: str, value: float = 0.0) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        found = (RadiusDiscrepancy(project.targets[0].name, 0.17, 0.3, cause, value),)
        return replace(project, result=replace(project.result, radius_discrepancies=found))

    return change


def _shorter(project: Project) -> Project:
    assert project.result is not None
    model = StochasticModel(position_time=30.0, attitude_time=60.0)
    return replace(
        project, result=replace(project.result, model=model, given_correlation_times=(300.0, 600.0))
    )


def _shorter_with_sigmas(project: Project) -> Project:
    shorter = _shorter(project).result
    assert shorter is not None
    at_given_times = np.radians([0.0071, 0.0077, 0.0102])
    return replace(project, result=replace(shorter, sigma_at_given_times=at_given_times))


def _raised_conservative(project: Project) -> Project:
    raised = _raised(project).result
    assert raised is not None
    test = replace(raised.chi_square, statistic=raised.chi_square.lower * 0.9)
    return replace(project, result=replace(raised, chi_square=test))


def _raised(project: Project) -> Project:
    assert project.result is not None
    return replace(project, result=with_raised_sigmas(project.result, np.array([1.0, 2.5, 1.02])))


def _uncertain_lever_arm(project: Project) -> Project:
    assert project.result is not None
    effect = np.zeros((len(project.result.estimated), 3))
    effect[2, 0] = np.radians(5.0)  # per metre
    model = replace(project.result.model, lever_arm_sigma=(0.01, 0.02, 0.03))
    result = replace(project.result, model=model, lever_arm_effect=effect)
    covariance = result.covariance_all + result.lever_arm_covariance
    return replace(project, result=replace(result, covariance_all=covariance))


def _apart(significance: float, difference_deg: float = -0.1512) -> Callable[[Project], Project]:
    """The pitch without a line differs by a number of standard deviations."""

    def change(project: Project) -> Project:
        checks = project.cross_checks
        assert checks is not None
        sigmas, off = np.array([-0.2, significance, 1.0]), np.radians([0.0, difference_deg, 0.0])
        odd = replace(checks.parts[1], significance=sigmas, difference=off)
        parts = (checks.parts[0], odd, *checks.parts[2:])
        return replace(project, cross_checks=replace(checks, parts=parts))

    return change


def _badly_separated(project: Project) -> Project:
    assert project.result is not None
    covariance = project.result.covariance_all.copy()
    covariance[0, 1] = covariance[1, 0] = -0.97 * np.sqrt(covariance[0, 0] * covariance[1, 1])
    return replace(project, result=replace(project.result, covariance_all=covariance))


def _model(**values: object) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        model = StochasticModel(**values)  # type: ignore[arg-type]
        return replace(project, result=replace(project.result, model=model))

    return change


def _sighting(**values: object) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        first, *rest = project.result.reliability
        odd = replace(first, **values)  # type: ignore[arg-type]
        return replace(project, result=replace(project.result, reliability=(odd, *rest)))

    return change


def _without_line(project: Project) -> Project:
    assert project.result is not None
    items = tuple(
        replace(item, rejected=item.sighting.line == "L3") for item in project.result.reliability
    )
    return replace(project, result=replace(project.result, reliability=items))


def _noise(*factors: float) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        noisy = tuple(
            replace(target, noise=factor)
            for target, factor in zip(project.result.targets, factors, strict=False)
        )
        return replace(project, result=replace(project.result, targets=noisy))

    return change


def _facing(count: int) -> Callable[[Project], Project]:
    def change(project: Project) -> Project:
        assert project.result is not None
        first, second = project.result.targets
        targets = (first, replace(second, plane=first.plane))[:count]
        return replace(project, result=replace(project.result, targets=targets))

    return change


def _contradicted(project: Project) -> Project:
    assert project.result is not None
    sigma = project.result.sigma
    found = ContradictedParameter("lever_x", -0.0951, 0.0041, sigma * [0.1, -14.2, 0.6], 0.0)
    return replace(project, result=replace(project.result, contradictions=(found,)))


def _bent(project: Project) -> Project:
    assert project.result is not None
    return replace(project, result=replace(project.result, surface=0.0071))


def _displaced(project: Project) -> Project:
    assert project.result is not None
    return replace(project, result=replace(project.result, surface=1e-5, offset=0.0071))


def _not_flat(project: Project) -> Project:
    return _noise(1.0, 2.4)(_unchecked("line", lines=2)(project))


def _assumed(project: Project) -> Project:
    """The LiDAR sigma was estimated, those of the POS were assumed."""
    assert project.result is not None
    found = (VarianceComponent("LiDAR", 0.4, 0.38, 0.42, True, 0.4),)
    return replace(
        project, result=replace(project.result, components=found, assumed_sigmas=SIGMA_GROUPS)
    )


def _control_translated(project: Project) -> Project:
    return with_control(project, w=7.5, translation=(0.0101, 0.0202, 0.3003))


CASES = [
    ("assumed_sigmas", False, _assumed, "data: position 0.020 m, 0.020 m, 0.030 m (north, east, "
     "down) and attitude 0.0100 deg, 0.0100 deg, 0.0150 deg (roll, pitch, heading). Enter"),
    ("contradicted_lever_x", True, _contradicted, "The given lever arm X disagrees with the data: "
     "the best-fitting value, smaller by 0.0951 m (+/- 0.0041 m, test value w = -23.2), would "
     "change pitch by -"),
    ("surfaces_differ", False, _bent, "differ between lines by 7.1 mm (1 sigma)"),
    ("surfaces_displaced", False, _displaced, "displaced by 7.1 mm and tilted by 0.0 mm"),
    ("large_sigma", True, _wide, "(1 sigma): roll 0.49 deg. Add targets"),
    ("large_sigma_unseen", True, _unseen, "given values: scan-angle offset. Give"),
    ("line_unchecked", True, _unchecked("line", lines=2), "any one of the lines L1 and L2 the"),
    ("target_unchecked", True, _unchecked("target", of_target=True), "Without target T1"),
    ("targets_clustered", True, _unchecked("clustered", size=0.031), "over only 3 % of"),
    ("carried_by_one", True, _unchecked("sighting", lines=1, of_target=True,
                                        angles=("pitch", "yaw")), "T1 on line L1 (pitch and yaw)"),
    ("target_excluded", False, _excluded, "other targets and lines: T1 and T2"),
    ("target_cut", False, _cut(0.34), "34 % of the points of T1"),
    ("target_parts", False, _cut(0.0), "may not be flat: T1"),
    ("radii_differ", True, _radii(""), "from 170.0 to 300.0 mm, and no single error explains it"),
    ("radii_pitch_sign", True, _radii("pitch_sign"), "but agrees with the opposite sign of pitch"),
    ("radii_parameter", True, _radii("latency", -0.02), "parameter (latency smaller by 20.00 ms)"),
    ("radii_parameter", True, _radii("range_offset", 0.02), "range offset larger by 0.0200 m"),
    ("shorter_times", False, _shorter, "of 300 s (position) and 600 s (attitude)"),
    ("shorter_times_sigmas", False, _shorter_with_sigmas, "instead of 0.0102"),
    ("lever_arm_uncertainty", False, _uncertain_lever_arm,
     "The standard deviation of the given lever arm (10, 20, 30 mm) increases those of the angles: "
     "yaw from "),
    ("sigmas_raised", False, _raised, "the result: pitch from 0.0291 to 0.0728"),
    ("sigmas_raised_conservative", False, _raised_conservative, "The residuals are smaller than "
     "the standard deviations used predict, but"),
    ("cross_check_uncovered", True, _apart(4.1), "without line L2 (pitch -0.1512 deg, 4.1 times "
     "its standard deviation)"),
    ("cross_check", False, lambda project: _apart(4.1)(_raised(project)), "without line L2 (pitch "
     "-0.1512 deg, 4.1 times its standard deviation)"),
    ("cross_check", False, _apart(3.1), "without line L2 (pitch -0.1512 deg, 3.1 times"),
    ("cross_check", False, _apart(4.1, -0.0512), "without line L2 (pitch -0.0512 deg, 4.1 times"),
    ("high_correlation", False, _badly_separated, "correlation of roll and pitch is -0.97"),
    ("independent_pos_errors", True, _model(pos_errors="independent"), "uncorrelated POS errors"),
    ("control_contradicts", True, lambda project: with_control(project, w=7.5), "Control point C2 "
     "lies 23.2 mm (+/- 3.1 mm, test value w = +7.5) from the surface of T1"),
    ("control_translated", True, _control_translated, "control.csv is displaced as a whole "
     "from all other observations: +10.1 mm north (+/- 4.0 mm), +20.2 mm west (+/- 4.0 mm) and "
     "+300.3 mm up (+/- 4.0 mm). Check"),
    ("steep_pitch", False, _steep, "The boresight pitch exceeds 60 deg"),
    ("surface_held", False, _model(surface=0.0), "The form error of the targets is fixed at 0"),
    ("released", False, _sighting(rejected=True, shift=-0.0483, w=-9.34), "was rejected: "
     "T1 on line L1 (displaced by 48.3 mm, test value w = -9.3)."),
    ("sighting_disagrees", False, _sighting(shift=0.02, w=5.5), "but is used: T1 on line "
     "L1 (displaced by 20.0 mm, test value w = +5.5)."),
    ("line_jumped", False, _without_line, "All targets are displaced on line L3"),
    ("strays_full_weight", False, _sighting(outliers=60), "60 of"),
    ("noise", False, _noise(1.0, 2.4), "on T2 indicate 2.4 times the LiDAR noise used: the "
     "surface"),
    ("noise", False, _noise(2.2, 2.4), "on T2 and T1 indicate up to 2.4 times the LiDAR noise "
     "used: the surfaces"),
    ("not_flat", True, _not_flat, "is probably not flat (residuals 2.4 times the given noise)"),
    ("another_surface", False, _noise(41.0, 1.0), "The points of target T1 deviate from its "
     "surface by 41.0 times the LiDAR noise"),
    ("estimated_lever_arm_differs", True, _lever_arm_changed, "lever arm Z differs from the given "
     "one: it is of the opposite sign, changed by 4.8380 m (+/- 0.0100 m)"),
    ("one_facing", True, _facing(2), "All targets are nearly parallel"),
    ("one_target", True, _facing(1), "T1 is the only target"),
]  # fmt: skip


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("warnings") / "harbour")


@pytest.mark.parametrize(
    ("code", "serious", "change", "words"), CASES, ids=[f"{c[0]}-{k}" for k, c in enumerate(CASES)]
)
def test_each_warning_is_the_same_everywhere(
    capsys: pytest.CaptureFixture[str], project: Project, code: str, serious: bool,
    change: Callable[[Project], Project], words: str,
) -> None:  # fmt: skip
    changed = change(project)
    result, checks = changed.result, changed.cross_checks
    assert result is not None
    (found,) = [
        each for each in result_warnings(result, checks) if each.code == f"adjustment.{code}"
    ]
    text = to_plain_text(message_text(found))
    assert words in text
    assert (found.level is Level.WARNING) == serious
    assert text.isascii()
    print_result(result, checks)
    assert f"- {text}\n" in capsys.readouterr().out
    values = json_values(found)
    assert to_plain_text(values["text"]) == text
    assert values in json_values(adjustment_output(result, checks))["warnings"]
    assert "are realistic" not in result_texts.fit_verdict(result, checks)
    assert [each for each in sample_content(changed).warnings if each.code == found.code] == [found]


@pytest.mark.parametrize("case", CASES, ids=[f"{c[0]}-{k}" for k, c in enumerate(CASES)])
def test_warning_texts_are_in_the_current_language(
    project: Project, case: tuple[str, bool, Callable[[Project], Project], str]
) -> None:
    code, _, change, _ = case
    changed = change(project)
    assert changed.result is not None
    warnings = result_warnings(changed.result, changed.cross_checks)
    (found,) = [each for each in warnings if each.code == f"adjustment.{code}"]
    with in_language("fr"):
        assert message_text(found) != message_text_in("en", found)


def message_text_in(language: str, message: Message) -> str:
    with in_language(language):
        return message_text(message)


def test_the_cases_trigger_every_rule(project: Project) -> None:
    triggered = set()
    results = [change(project) for _, _, change, _ in CASES]
    assert project.result is not None
    targetless = replace(project.result, messages=(note("targetless.with_targets", targets=2),))
    for changed in (*results, replace(project, result=targetless)):
        assert changed.result is not None
        for rule in WARNING_RULES:
            if any(rule(changed.result, changed.cross_checks)):
                triggered.add(rule)
    assert triggered == set(WARNING_RULES)


def test_a_good_result_has_no_warning(
    capsys: pytest.CaptureFixture[str], project: Project, tmp_path: Path
) -> None:
    result, checks = project.result, project.cross_checks
    assert result is not None
    assert result_warnings(result, checks) == ()
    sure = f"{AGREE_TEXT} {result_texts.REALISTIC_TEXT}"
    assert result_texts.fit_verdict(result, checks) == sure
    lidar = VarianceComponent("LiDAR", 0.7, 0.65, 0.75, applied=True)
    estimated = result_texts.fit_verdict(replace(result, components=(lidar,)), checks)
    assert estimated == f"{NOT_JUDGED_TEXT} {result_texts.REALISTIC_TEXT}"
    unchecked = result_texts.fit_verdict(replace(result, components=(lidar,)), None)
    assert unchecked == NOT_JUDGED_TEXT, "neither the test nor the cross-checks confirm the sigmas"
    print_result(result, checks)
    assert "Warnings and notes:" not in capsys.readouterr().out


def test_an_agreement_by_construction_is_not_shown_as_a_confirmation(project: Project) -> None:
    result = project.result
    assert result is not None
    assert theme.DONE in result_texts.chi_square_text(result)
    lidar = VarianceComponent("LiDAR", 0.7, 0.65, 0.75, applied=True)
    unused = replace(result, components=(replace(lidar, applied=False),), surface=0.0049)
    fixed = replace(result, model=StochasticModel(surface=0.12), surface=0.12)
    for given in (unused, fixed):
        assert agreement_template(given) == AGREE_TEXT
        assert theme.DONE in result_texts.chi_square_text(given)
    for estimated, template in (
        (replace(result, components=(lidar,)), NOT_JUDGED_TEXT),
        (replace(result, lidar_noise_from_residuals=True), NOT_JUDGED_TEXT),
        (replace(result, surface=0.124), AGREE_ESTIMATED_TEXT),
        (replace(result, surface=0.0, offset=0.124), AGREE_ESTIMATED_TEXT),
    ):
        assert agreement_template(estimated) == template
        text = result_texts.chi_square_text(estimated)
        assert theme.MUTED in text
        assert theme.DONE not in text


def test_a_given_and_estimated_value_does_not_explain_a_large_sigma(project: Project) -> None:
    lever_x = ParameterEstimate("lever_x", 0.0, 0.01, value=0.004, sigma=0.006, significance=0.5)
    wide = _wide(project).result
    assert wide is not None
    (large,) = result_warnings(replace(wide, parameters=(lever_x,)), None)
    assert large.code == "adjustment.large_sigma"


def test_serious_warnings_come_first(project: Project) -> None:
    changed = _raised(_wide(project))
    assert changed.result is not None
    levels = [each.level for each in result_warnings(changed.result, changed.cross_checks)]
    assert levels == [Level.WARNING, Level.NOTE]


def test_warnings_are_the_same_after_saving(project: Project, tmp_path: Path) -> None:
    saved = replace(_contradicted(project), folder=tmp_path)
    write_project(saved)
    opened = read_project(tmp_path)
    assert opened.result is not None
    assert saved.result is not None
    assert result_warnings(opened.result, opened.cross_checks) == result_warnings(
        saved.result, saved.cross_checks
    )
    (found,) = opened.result.contradictions
    np.testing.assert_array_equal(found.angle_change, saved.result.contradictions[0].angle_change)


@pytest.mark.parametrize("points", [1, 2, 50, 999, 2_215, 1_000_000])
def test_the_limit_of_random_outliers_follows_the_binomial_distribution(points: int) -> None:
    assert exceedance_limit(points, 0.001) == stats.binom.isf(0.001, points, 0.001)
