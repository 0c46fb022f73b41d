"""Fixtures of the tests of the workflow."""

from pathlib import Path

import pytest

from lispac.workflow.importing.input_files import InputFiles
from tests.support.input_file_samples import import_files, write_survey


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a simulated survey."""
    return write_survey(tmp_path_factory.mktemp("survey"))


@pytest.fixture(scope="module")
def whole(files: Path) -> InputFiles:
    """Return all files of this folder."""
    return import_files(InputFiles(), files)
