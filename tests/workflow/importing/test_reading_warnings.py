"""Tests of warnings about how files are read, from the import to the report."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.duplicate_targets import all_warnings
from lispac.messages import Level, note
from lispac.project import LineSource, Project, Reading, Settings
from lispac.workflow.checking.warnings import warnings_of
from lispac.workflow.output.export import report_content_of
from lispac.workflow.project.projects import new_project, open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.input_file_samples import LEVER, START, write_line
from tests.support.report_sample import sample_project
from tests.support.trajectory_files import vessel, write_records

ZERO_RATES = "sbet.zero_rates"


@pytest.fixture
def imported(tmp_path: Path) -> tuple[Project, Survey]:
    """Return a project whose trajectory has no angular rates, so that its signs are assumed."""
    records = vessel(2000)
    records[:, 14:17] = 0.0
    track = write_records(tmp_path / "pos.sbet", records)
    line = write_line(tmp_path / "L.las", START + np.linspace(5, 30, 3000))
    return new_project(
        tmp_path / "p", trajectory=track, lines=[LineSource("L", line, reading=Reading())],
        settings=Settings(lever_arm=LEVER),
    )  # fmt: skip


def test_a_warning_of_the_import_is_a_warning_everywhere(imported: tuple[Project, Survey]) -> None:
    project, survey = imported
    reopened = open_project(project.folder)
    for some, data in ((project, survey), (reopened, load_survey(reopened))):
        assert ZERO_RATES not in {each.code for each in data.notes}
        lists = (
            data.messages, warnings_of(some, data), report_content_of(some, data).warnings
        )  # fmt: skip
        for messages in lists:
            (found,) = [each for each in messages if each.code == ZERO_RATES]
            assert found.level is Level.WARNING


def test_a_confirmed_sign_is_no_longer_a_warning(
    imported: tuple[Project, Survey], tmp_path: Path
) -> None:
    _, survey = imported
    project = sample_project(tmp_path / "sample").with_data_messages(survey.messages)
    assert project.result is not None
    assert ZERO_RATES in {each.code for each in all_warnings(project)}
    agrees = note("adjustment.signs_agree", ratio=9.0)
    confirmed = replace(project, result=replace(project.result, messages=(agrees,)))
    codes = [each.code for each in all_warnings(confirmed)]
    assert ZERO_RATES not in codes
    assert "adjustment.signs_agree" in codes
