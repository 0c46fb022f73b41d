"""Tests of the predicted sigmas of a proposal: storage and comparison with the result."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.adjustment.result import ANGLES
from lispac.duplicate_targets import all_warnings, prediction_warnings
from lispac.io.project.project_file import read_project, write_project
from lispac.message_texts import english_text
from lispac.messages import Level, note
from lispac.project import Project, ProposalPrediction
from lispac.workflow.calibration.proposal_acceptance import with_accepted_targets
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.project.survey import Survey

ABOVE_CODE, BELOW_CODE = "targets.sigma_above_prediction", "targets.sigma_below_prediction"


def predicted(project: Project, factors: tuple[float, float, float]) -> Project:
    """Return the project with a prediction; sigmas are its values times ``factors``."""
    assert project.result is not None
    names = tuple(target.name for target in project.targets_of_role("target"))
    return project.with_prediction(ProposalPrediction(names, project.result.sigma / factors))


@pytest.mark.parametrize(
    ("factors", "above", "below"),
    [
        ((1.0, 1.0, 1.0), (), ()),
        ((1.19, 0.81, 1.0), (), ()),
        ((1.0, 1.21, 1.0), ("pitch",), ()),
        ((0.79, 1.0, 3.0), ("yaw",), ("roll",)),
    ],
)
def test_sigmas_that_differ_by_a_fifth_are_named(
    calibrated: tuple[Project, Survey],
    factors: tuple[float, float, float],
    above: tuple[str, ...],
    below: tuple[str, ...],
) -> None:
    project = predicted(calibrated[0], factors)
    assert project.result is not None
    messages = all_warnings(project)
    for code, level, named in ((ABOVE_CODE, Level.NOTE, above), (BELOW_CODE, Level.WARNING, below)):
        found = [message for message in messages if message.code == code]
        assert [message.level for message in found] == [level] * bool(named)
        for message in found:
            text = english_text(message)
            assert tuple(angle for angle in ANGLES if f"{angle} 0." in text) == named
            for k in map(ANGLES.index, named):
                sigma_deg = np.degrees(project.result.sigma[k])
                assert f"{sigma_deg:.4f} instead of {sigma_deg / factors[k]:.4f}°" in text


def test_edits_of_targets_or_settings_discard_the_prediction(
    calibrated: tuple[Project, Survey],
) -> None:
    project = predicted(calibrated[0], (1, 1, 1))
    target, plane = project.targets_of_role("target")[0], project.targets_of_role("validation")[0]
    settings = replace(project.settings, lidar_sigma=0.1)
    for edited in (
        project.without_target(target.name),
        project.with_target(replace(target, used=False)),
        project.with_settings(settings),
    ):
        assert edited.prediction is None
    assert project.without_target(plane.name).prediction is project.prediction


def test_the_prediction_is_that_of_the_accepted_targets(
    calibrated: tuple[Project, Survey],
) -> None:
    """Targets picked before are included; with another target there is no prediction."""
    project, _ = calibrated
    sigma = np.array([1e-4, 2e-4, 3e-4])
    reasons = {target.name: note("propose.target_needed", lines=2) for target in project.targets}
    proposal = Proposal(
        project.targets, reasons, lambda used: sigma / len(used) if used else np.full(3, np.inf)
    )
    bare = replace(project, targets=(), result=None)
    names = [target.name for target in project.targets]
    targets = {target.name for target in project.targets_of_role("target")}
    accepted, _ = with_accepted_targets(bare, proposal, names)
    assert accepted.prediction is not None
    assert set(accepted.prediction.targets) == targets
    assert (accepted.prediction.sigma == sigma / len(targets)).all()
    assert prediction_warnings(accepted) == ()
    without_planes, _ = with_accepted_targets(bare, proposal, targets)
    assert without_planes.prediction is not None
    fewer, _ = with_accepted_targets(bare, proposal, sorted(targets)[1:])
    assert fewer.prediction is not None
    assert (fewer.prediction.sigma == sigma / (len(targets) - 1)).all()
    assert with_accepted_targets(bare, proposal, set(names) - targets)[0].prediction is None
    own = bare.with_target(replace(project.targets_of_role("target")[0], name="own"))
    assert with_accepted_targets(own, proposal, names)[0].prediction is None
    also, _ = with_accepted_targets(own, replace(proposal, picked=("own",)), names)
    assert also.prediction is not None
    assert set(also.prediction.targets) == targets | {"own"}


def test_the_prediction_is_saved_and_absent_in_older_files(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    project = replace(predicted(calibrated[0], (1.5, 1, 1)), folder=tmp_path / "kept")
    write_project(project)
    read = read_project(project.folder)
    assert read.prediction is not None
    assert project.prediction is not None
    assert read.prediction.targets == project.prediction.targets
    assert (read.prediction.sigma == project.prediction.sigma).all()
    assert [message.code for message in prediction_warnings(read)] == [ABOVE_CODE]
    (file,) = (
        path for path in project.folder.iterdir() if path.suffix == ".json" and path.is_file()
    )
    content = json.loads(file.read_text(encoding="utf-8"))
    del content["prediction"]
    file.write_text(json.dumps(content), encoding="utf-8")
    assert read_project(project.folder).prediction is None
