"""Tests that no function is compiled while the user waits for a result."""

import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from lispac import compiled_code
from lispac.locks import file_lock
from lispac.project import Project
from lispac.workflow.planning import precompile

CHECKOUT = Path(__file__).resolve().parents[2]
CALIBRATION = """
import sys
from dataclasses import replace
from pathlib import Path

from numba.core import event

compiled = []


class Listener(event.Listener):
    def on_start(self, event):
        pass

    def on_end(self, event):
        compiled.append(event.data["dispatcher"].py_func.__qualname__)


event.register("numba:compile", Listener())
from lispac.workflow.output.export import write_report
from lispac.workflow.planning.demo import calibrate_demo
from lispac.workflow.project.projects import open_project

project = replace(open_project(Path(sys.argv[1])), targets=(), result=None)
project, survey = calibrate_demo(project)
write_report(project, survey, Path(sys.argv[1]) / "report.pdf")
print(" ".join(compiled))
"""


@pytest.mark.long
def test_a_calibration_compiles_nothing_after_precompilation(
    tmp_path: Path, whole_demo: Project
) -> None:
    """The demo has four times as many points as the survey with which functions are compiled."""
    variables = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "cache")}

    def run(*words: str) -> str:
        return subprocess.run(
            [sys.executable, *words],
            cwd=CHECKOUT, env=variables, capture_output=True, text=True, check=True,
        ).stdout  # fmt: skip

    run("-m", "lispac.workflow.planning.precompile")
    (cache,) = (tmp_path / "cache").iterdir()
    assert (cache / precompile.FINISHED_FILE).is_file()
    assert not (cache / precompile.SURVEY_FOLDER).exists()
    folder = shutil.copytree(whole_demo.folder, tmp_path / "copy")
    assert run("-c", CALIBRATION, str(folder)).split() == []


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(compiled_code, "current_cache_folder", lambda: tmp_path)
    return tmp_path


def test_functions_are_compiled_once(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    runs: list[Path] = []

    def run(folder: Path) -> None:
        assert not folder.exists()  # what a process left that was ended has been removed
        folder.mkdir()
        runs.append(folder)

    monkeypatch.setattr(precompile, "run_all_methods", run)
    (cache / precompile.SURVEY_FOLDER).mkdir()
    precompile.precompile()
    precompile.precompile()
    assert len(runs) == 1
    assert {path.name for path in cache.iterdir()} == {precompile.FINISHED_FILE}


def test_functions_are_compiled_again_after_an_error(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(folder: Path) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(precompile, "run_all_methods", fail)
    with pytest.raises(OSError, match="disk full"):
        precompile.precompile()
    assert list(cache.iterdir()) == []


def test_only_one_process_compiles(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def run(folder: Path) -> None:
        other = threading.Thread(target=precompile.precompile)
        other.start()
        other.join()
        runs.append(folder)

    runs: list[Path] = []
    monkeypatch.setattr(precompile, "run_all_methods", run)
    precompile.precompile()
    assert len(runs) == 1
    with file_lock(cache / precompile.LOCK_FILE):
        (cache / precompile.FINISHED_FILE).unlink()
        precompile.precompile()
    assert len(runs) == 1
