"""Time of the short report of the built-in survey; run with ``pytest tests/benchmarks``.

By the command, the second time, with the processor time; and in a running program: the first
report, and the same report again.
"""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from lispac.project import Project
from lispac.workflow.output.export import write_report
from lispac.workflow.project.survey import Survey

AIM_SECONDS = 5.0


def seconds(run: Callable[[], object]) -> float:
    """Wall-clock time of one run."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def command_times(command: list[str]) -> tuple[float, float]:
    """Elapsed and processor time of a command, with its child processes, s."""
    before = os.times()
    elapsed = seconds(lambda: subprocess.run(command, check=True, capture_output=True, timeout=600))
    after = os.times()
    user = after.children_user - before.children_user
    return elapsed, user + after.children_system - before.children_system


@pytest.mark.parametrize("ending", ["pdf", "html"])
def test_report(denser_calibrated: tuple[Project, Survey], tmp_path: Path, ending: str) -> None:
    project, survey = denser_calibrated
    path = tmp_path / f"r.{ending}"
    command = [sys.executable, "-m", "lispac", "report", str(project.folder), "--output", str(path)]
    command_times(command)  # writes byte code
    whole, processor = command_times(command)
    first = seconds(lambda: write_report(project, survey, path))
    again = seconds(lambda: write_report(project, survey, path))
    print(
        f"\n{ending}: the command {whole:.1f} s (aim {AIM_SECONDS:.0f} s), of processor time "
        f"{processor:.1f} s, in a running program {first:.1f} s, once more {again:.1f} s"
    )
