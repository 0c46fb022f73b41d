"""Tests of the finder choices of the user: use, storage with the target, and reselection."""

import json
import shutil
from dataclasses import replace
from math import inf, nan, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError, ProjectError, TargetNotFound
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices, FinderSettings
from lispac.workflow.calibration import reselection
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.target_search import TargetSearch
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.command_errors import codes_of
from tests.support.long_runs import LONG
from tests.support.report_sample import sample_project

SEED = demo_seeds()["T1"][1]
CHOSEN = FinderChoices(min_points=50, max_tilt=radians(8.0), stop=0.9, seed=7)


@pytest.fixture(scope="module")
def survey(demo_project: Project) -> Survey:
    """The built-in survey."""
    return load_survey(demo_project)


def test_the_default_choices_are_those_of_the_finder() -> None:
    assert DEFAULT_CHOICES.settings() == FinderSettings()
    assert CHOSEN.settings(radius=3.0) == FinderSettings(
        radius=3.0, min_points=50, max_tilt=radians(8.0), stop=0.9, seed=7
    )


@pytest.mark.parametrize(
    "wrong",
    [
        {"min_points": 2}, {"max_tilt": 0.0}, {"max_tilt": 1.6}, {"max_tilt": nan}, {"stop": 1.0},
        {"stop": 0.0}, {"stop": inf}, {"seed": -1},
    ],
)  # fmt: skip
def test_invalid_choices_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=next(iter(wrong))):
        FinderChoices(**wrong)


@LONG
def test_choices_determine_which_points_are_found(demo_project: Project, survey: Survey) -> None:
    usual = find_target(demo_project, survey, SEED, name="T1")
    assert usual.choices == DEFAULT_CHOICES
    sizes = sorted(len(sighting.indices) for sighting in usual.sightings)
    between = (sizes[0] + sizes[-1]) // 2
    fewer = find_target(
        demo_project, survey, SEED, name="T1", choices=FinderChoices(min_points=between)
    )
    assert 0 < len(fewer.sightings) < len(usual.sightings)
    assert min(len(sighting.indices) for sighting in fewer.sightings) >= between
    assert fewer.choices.min_points == between
    with pytest.raises(TargetNotFound, match=f"{10 * sizes[-1]:,}"):
        find_target(
            demo_project, survey, SEED, name="T1",
            choices=FinderChoices(min_points=10 * sizes[-1]),
        )  # fmt: skip
    drawn = [
        find_target(
            demo_project, survey, SEED, name="T1", choices=FinderChoices(seed=seed, stop=0.5)
        )
        for seed in (3, 3)
    ]
    for one, other in zip(drawn[0].sightings, drawn[1].sightings, strict=True):
        np.testing.assert_array_equal(one.indices, other.indices)


def test_reselection_uses_the_choices_of_the_target(
    demo_project: Project, survey: Survey, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = find_target(demo_project, survey, SEED, name="T1", choices=CHOSEN)
    used: list[FinderSettings] = []
    real = TargetSearch.find_in_lines

    def watched(self: TargetSearch, clouds: Any, seed: Any, settings: Any, **others: Any) -> Any:
        used.append(settings)
        return real(self, clouds, seed, settings, **others)

    monkeypatch.setattr(TargetSearch, "find_in_lines", watched)
    clouds: dict[str, Cloud] = dict(survey.clouds)
    again = reselection.reselect_target(target, clouds, clouds)
    assert used == [
        CHOSEN.settings(
            radius=target.radius, threshold=reselection.THRESHOLD_FACTOR * target.threshold,
            max_shift=reselection.ALIGNED_MAX_SHIFT,
        )
    ]  # fmt: skip
    assert again.choices == CHOSEN
    # If more points are required than exist, nothing is found and the target does not change.
    many = replace(target, choices=FinderChoices(min_points=1_000_000))
    assert reselection.reselect_target(many, clouds, clouds) is many


def test_the_project_stores_choices_other_than_the_default(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    first = replace(project.targets[0], choices=CHOSEN)
    project = replace(project, targets=(first, *project.targets[1:]))
    write_project(project)
    content = json.loads((tmp_path / "p" / PROJECT_FILE_NAME).read_text())
    assert [target["choices"] is None for target in content["targets"]] == [
        False, *(True for _ in project.targets[1:])
    ]  # fmt: skip
    read = read_project(tmp_path / "p")
    assert [t.choices for t in read.targets] == [
        CHOSEN,
        *(DEFAULT_CHOICES for _ in project.targets[1:]),
    ]
    for wrong, code in (
        ({"min_points": 2}, "finder.setting"),
        ({"surprise": 1}, "content.unknown_fields"),
    ):
        damaged = json.loads(json.dumps(content))
        damaged["targets"][0]["choices"] |= wrong
        (tmp_path / "p" / PROJECT_FILE_NAME).write_text(json.dumps(damaged))
        with pytest.raises(ProjectError) as refused:
            read_project(tmp_path / "p")
        assert code in codes_of(refused.value)


def test_a_project_of_an_earlier_version_has_the_default_choices(tmp_path: Path) -> None:
    old = Path(__file__).parents[2] / "data" / "project-3"
    read = read_project(Path(shutil.copytree(old, tmp_path / "old")))
    assert read.result is not None
    assert {target.choices for target in read.targets} == {DEFAULT_CHOICES}


@LONG
def test_choices_can_be_given_at_the_command_line(
    capsys: pytest.CaptureFixture[str], demo_project: Project, tmp_path: Path
) -> None:
    folder = shutil.copytree(demo_project.folder, tmp_path / "demo")
    chosen = ["--min-points", "50", "--max-tilt", "8", "--stop", "0.9", "--random-seed", "7"]
    seed = ["--seed", *(str(value) for value in SEED), "--name", "T1"]
    assert main(["pick", str(folder), *seed, *chosen, "--json"]) == 0
    picked = json.loads(capsys.readouterr().out)
    assert (picked["min_points"], picked["stop"], picked["random_seed"]) == (50, 0.9, 7)
    assert picked["max_tilt_deg"] == pytest.approx(8.0)
    assert read_project(Path(folder)).target("T1").choices == CHOSEN
    for wrong in (
        ["--min-points", "2"], ["--min-points", "9.5"], ["--max-tilt", "0"], ["--max-tilt", "91"],
        ["--stop", "1"], ["--random-seed", "-1"],
    ):  # fmt: skip
        try:
            code = main(["pick", "nowhere", *seed, *wrong])
        except SystemExit as stop:
            code = int(stop.code or 0)
        assert code == 2, wrong
    capsys.readouterr()
    # The choices apply to a list of seeds too.
    path = tmp_path / "targets.txt"
    path.write_text("T9 " + " ".join(str(value) for value in SEED))
    assert main(["pick", str(folder), "--seeds", str(path), *chosen]) == 0
    assert read_project(Path(folder)).target("T9").choices == CHOSEN
