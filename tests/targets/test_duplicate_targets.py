"""Tests that duplicate targets are reported when picked, with the result and in the report."""

import json
import shutil
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.cli.calibration.result_output import print_result, project_adjustment_output
from lispac.duplicate_targets import (
    duplicate_warnings,
    find_overlap,
    find_overlaps,
    overlap_warning,
)
from lispac.gui.features.estimate import result_texts
from lispac.gui.project.status import step_statuses
from lispac.message_texts import message_text
from lispac.project import PickedSighting, Project, Role, Target
from lispac.workflow.planning.demo import demo_seeds
from tests.cli.test_cli import run
from tests.support.message_codes import is_shown
from tests.support.report_sample import sample_content, sample_project


def picked(
    name: str, points: Mapping[str, range], role: Role = "target", *, used: bool = True
) -> Target:
    """A target with these point numbers on these lines."""
    sightings = tuple(
        PickedSighting(line, np.array(numbers, dtype=np.int64), 0.002)
        for line, numbers in points.items()
    )
    return Target(name, role, (0.0, 0.0, 0.0), 0.01, 1.25, sightings, used=used)


BOARD = picked("T2", {"L1": range(1000, 2000), "L2": range(5000, 6000)})
DUPLICATE = picked("T6", {"L1": range(1110, 2110), "L2": range(5500, 6500)})
WALL = picked("V1", {"L1": range(0, 40_000, 3), "L2": range(7000, 9000)}, "validation")


def test_the_share_is_the_largest_over_lines_relative_to_the_smaller_target() -> None:
    (found,) = find_overlaps([BOARD, DUPLICATE])
    assert (found.one, found.other, found.line) == ("T2", "T6", "L1")
    assert found.share == pytest.approx(0.89)
    small = picked("T7", {"L2": range(8500, 8600)})
    (found,) = find_overlaps([WALL, small])
    assert (found.smaller, found.share) == ("T7", 1.0)
    assert find_overlap(small, [BOARD, WALL, DUPLICATE]) == replace(found, one="T7", other="V1")


@pytest.mark.parametrize(
    ("shared", "is_reported"), [(0, False), (99, False), (100, True), (299, True)]
)
def test_a_share_of_a_tenth_or_more_is_reported(shared: int, is_reported: bool) -> None:
    other = picked("T3", {"L1": range(2000 - shared, 3000 - shared), "L9": range(10)})
    assert bool(find_overlaps([BOARD, other])) == is_reported
    found = overlap_warning(other, [BOARD])
    assert (found is not None) == is_reported
    if found is not None:
        assert found.code == "overlap.points_shared_twice"
        assert found.params["share"] == pytest.approx(shared / 1000)


def test_a_sighting_without_points_shares_no_points() -> None:
    empty = picked("T8", {"L1": range(0)})
    assert find_overlaps([BOARD, empty]) == ()
    assert overlap_warning(empty, [BOARD]) is None


def test_order_of_the_numbers_does_not_matter() -> None:
    mixed = np.random.default_rng(1).permutation(np.arange(1110, 2110))
    sighting = replace(DUPLICATE.sightings[0], indices=mixed)
    (found,) = find_overlaps([BOARD, replace(DUPLICATE, sightings=(sighting,))])
    assert found.share == pytest.approx(0.89)


def test_the_warning_for_a_target_just_found() -> None:
    found = overlap_warning(DUPLICATE, [BOARD])
    assert found is not None
    assert found.code == "overlap.same_surface_twice"
    assert found.params["share"] == pytest.approx(0.89)
    larger = overlap_warning(picked("T8", {"L1": range(0, 5000)}), [DUPLICATE])
    assert larger is not None
    assert larger.params["smaller"] == "T6"
    assert overlap_warning(replace(DUPLICATE, name="T2"), [BOARD]) is None, "it takes its place"
    checking = overlap_warning(replace(DUPLICATE, role="validation"), [BOARD])
    assert checking is not None
    assert checking.code == "overlap.same_surface_unchecked"
    assert overlap_warning(DUPLICATE, []) is None


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("doubles") / "harbour")


@pytest.mark.parametrize(
    ("second", "code", "serious", "pair"),
    [
        (DUPLICATE, "counted_twice", True, "T2 with T6 (89 % on L1)"),
        (replace(DUPLICATE, role="validation"), "no_independent_check", False,
         "T6 with T2 (89 % on L1)"),
    ],
)  # fmt: skip
def test_a_result_with_shared_points_has_a_warning_everywhere(
    capsys: pytest.CaptureFixture[str], project: Project, second: Target, code: str,
    serious: bool, pair: str,
) -> None:  # fmt: skip
    assert duplicate_warnings(project) == ()
    both = replace(project, targets=(BOARD, second))
    result, checks = both.result, both.cross_checks
    assert result is not None
    (message,) = duplicate_warnings(both)
    assert (message.code, message.is_serious) == (f"targets.{code}", serious)
    text = message_text(message)
    assert pair in text
    assert result_warnings(result, checks, duplicate_warnings(both))[0] == message
    print_result(result, checks, duplicate_warnings(both))
    assert f"- {text}\n" in capsys.readouterr().out
    assert message in project_adjustment_output(both, {}).warnings
    assert "can be used" not in result_texts.fit_verdict(result, checks, duplicate_warnings(both))
    assert message in sample_content(both).warnings
    step = step_statuses(both, None, waiting=False, refusal="")[2]
    assert ("with warnings" in step.sentence) == serious


def test_unused_targets_and_sightings_do_not_count(project: Project) -> None:
    excluded = replace(DUPLICATE, used=False)
    assert duplicate_warnings(replace(project, targets=(BOARD, excluded))) == ()
    no_lines = replace(
        DUPLICATE, sightings=tuple(replace(s, used=False) for s in DUPLICATE.sightings)
    )
    assert duplicate_warnings(replace(project, targets=(BOARD, no_lines))) == ()
    planes = tuple(replace(each, role="validation") for each in (BOARD, DUPLICATE))
    assert duplicate_warnings(replace(project, targets=planes)) == ()


def test_many_pairs_are_counted(project: Project) -> None:
    targets = tuple(replace(DUPLICATE, name=f"T{k}") for k in range(4))
    (message,) = duplicate_warnings(replace(project, targets=targets))
    text = message_text(message)
    assert "T0 with T1 (100 % on L1), " in text
    assert " and 2 more. These points" in text
    assert (message.code, message.params["count"]) == ("targets.counted_twice", 6)


@pytest.mark.long
def test_at_the_command_line(
    capsys: pytest.CaptureFixture[str], demo_project: Project, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(demo_project.folder, tmp_path / "demo"))
    for name in ("T1", "T2"):
        x, y, z = demo_seeds()[name][1]
        code, _, err = run(capsys, "pick", folder, "--name", name, "--seed", x, y, z)
        assert (code, is_shown("overlap.same_surface_twice", err)) == (0, False)
    code, _, err = run(capsys, "pick", folder, "--name", "T3", "--seed", x + 0.2, y, z)
    assert code == 0
    assert is_shown("overlap.same_surface_twice", err)
    code, _, err = run(capsys, "pick", folder, "--name", "T3", "--seed", x + 0.1, y, z)
    assert is_shown("overlap.same_surface_twice", err), "T3 is replaced, and T2 still there"
    words = ["pick", folder, "--name", "V1", "--role", "validation", "--seed", x, y, z, "--json"]
    code, out, err = run(capsys, *words)
    assert is_shown("overlap.same_surface_unchecked", err)
    assert json.loads(out)["same_points_as"]["share_of_the_smaller"] > 0.9
    code, out, _ = run(capsys, "estimate", folder, "--no-cross-checks")
    assert code == 0
    assert is_shown("targets.counted_twice", out)
    assert "T2 with T3 (" in out
    assert is_shown("targets.no_independent_check", out)
    assert "V1 with T2 (" in out
    code, out, _ = run(capsys, "validate", folder)
    assert is_shown("targets.no_independent_check", out)
    twice, unchecked = json.loads(run(capsys, "validate", folder, "--json")[1])["warnings"]
    assert twice["code"] == "targets.counted_twice"
    assert unchecked["code"] == "targets.no_independent_check"
