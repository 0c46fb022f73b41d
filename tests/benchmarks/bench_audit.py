"""Time of the audit of a line beside its import, and memory; prints, asserts nothing.

``LISPAC_AUDIT_POINTS=100_000_000`` adds lines of that many points.
"""

import os
import resource
import time
from collections.abc import Mapping
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.project import LineSource, Settings
from lispac.survey.point_screening import PointScreen, PointSelection
from lispac.workflow.line_import import import_lines
from lispac.workflow.projects import create_project
from tests.intake_files import LEVER, START, write_survey

SIZES = [1_000_000, 10_000_000]
if more := os.environ.get("LISPAC_AUDIT_POINTS"):
    SIZES.append(int(more))


def written(path: Path, count: int) -> Path:
    """A line of a profiler at a constant rate over 20 s, written a million points at a time."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.WEEK_TIME
    with laspy.open(path, mode="w", header=header) as writer:
        for first in range(0, count, 1_000_000):
            k = np.arange(first, min(count, first + 1_000_000))
            angle = 2 * np.pi * (k % 5000) / 5000
            ranges = 10 + 5 * np.sin(k / 700)
            points = laspy.ScaleAwarePointRecord.zeros(len(k), header=header)
            points.x, points.y = 0 * ranges, ranges * np.cos(angle)
            points.z, points.gps_time = ranges * np.sin(angle), START + 5 + 20 * k / count
            writer.write_points(points)
    return path


@pytest.mark.parametrize("count", SIZES)
def test_audit_beside_import(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    (tmp_path / "files").mkdir()
    folder = write_survey(tmp_path / "files")
    path = written(folder / "long.las", count)
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
            extra[name]  # the import unpacks every attribute, whoever asks for it first
        started = time.thread_time()
        used = screened(self, times, xyz, extra)
        spent[0] += time.thread_time() - started
        return used

    monkeypatch.setattr(PointScreen, "__call__", timed)
    fresh = PointScreen(PointSelection(), ranged=True)
    screened(fresh, np.arange(2.0), np.ones((2, 3)), {})  # compiled before
    started, processor = time.perf_counter(), time.process_time()
    import_lines(project)
    wall, whole = time.perf_counter() - started, time.process_time() - processor
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"\n{count:,} points: import {wall:.1f} s ({whole:.1f} s of processor), audit "
        f"{spent[0]:.2f} s of it, {100 * spent[0] / whole:.1f} %; at most {memory:,.0f} MB"
    )
