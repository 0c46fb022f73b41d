"""Time and memory of the audit of a line during its import; prints figures, asserts nothing.

``LISPAC_AUDIT_POINTS=100_000_000`` adds a line of that many points.
"""

import os
import resource
import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from lispac.project import LineSource, Settings
from lispac.survey.point_screening import PointScreen, PointSelection
from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.project.projects import create_project
from tests.support.input_file_samples import LEVER, write_long_line, write_survey

SIZES = [1_000_000, 10_000_000]
if more := os.environ.get("LISPAC_AUDIT_POINTS"):
    SIZES.append(int(more))


@pytest.mark.parametrize("count", SIZES)
def test_audit_beside_import(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    (tmp_path / "files").mkdir()
    folder = write_survey(tmp_path / "files")
    path = write_long_line(folder / "long.las", count)
    project = create_project(
        tmp_path / "p", trajectory=folder / "pos.sbet", accuracy=folder / "smrmsg.out",
        lines=[LineSource("long", path)], settings=Settings(LEVER),
    )  # fmt: skip
    spent = [0.0]
    screened = PointScreen.__call__

    def timed(
        self: PointScreen, times: np.ndarray, xyz: np.ndarray, extra: Mapping[str, np.ndarray]
    ) -> np.ndarray:
        for name in extra:
            extra[name]  # unpack here: the import needs every attribute anyway
        started = time.thread_time()
        used = screened(self, times, xyz, extra)
        spent[0] += time.thread_time() - started
        return used

    monkeypatch.setattr(PointScreen, "__call__", timed)
    fresh = PointScreen(PointSelection(), ranged=True)
    screened(fresh, np.arange(2.0), np.ones((2, 3)), {})  # compile
    started, processor = time.perf_counter(), time.process_time()
    import_lines(project)
    wall, whole = time.perf_counter() - started, time.process_time() - processor
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"\n{count:,} points: import {wall:.1f} s ({whole:.1f} s of processor), audit "
        f"{spent[0]:.2f} s of it, {100 * spent[0] / whole:.1f} %; at most {memory:,.0f} MB"
    )
