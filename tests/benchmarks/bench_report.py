"""Time of the full report of the built-in survey; run with ``pytest tests/benchmarks``.

By the command line, and in a running program: the first report, and a repeated one.
"""

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from lispac.project import Project
from lispac.workflow.output.export import write_report
from lispac.workflow.project.survey import Survey

AIM_SECONDS = 10.0


def seconds(run: Callable[[], object]) -> float:
    """Return the wall-clock time of one run."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


@pytest.mark.parametrize("ending", ["pdf", "html"])
def test_report(calibrated: tuple[Project, Survey], tmp_path: Path, ending: str) -> None:
    project, survey = calibrated
    path = tmp_path / f"r.{ending}"
    command = [sys.executable, "-m", "lispac", "report", str(project.folder), "--output", str(path)]
    whole = seconds(lambda: subprocess.run(command, check=True, capture_output=True, timeout=300))
    first = seconds(lambda: write_report(project, survey, path))
    again = seconds(lambda: write_report(project, survey, path))
    print(
        f"\n{ending}: the command {whole:.1f} s (aim {AIM_SECONDS:.0f} s), in a running program "
        f"{first:.1f} s, once more {again:.1f} s"
    )
