"""A monkey at the window finds no exception, no stall and no growth, and leaves nothing behind."""

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtGui import QGuiApplication

from lispac.workflow.project.projects import open_project, save_project
from tests.gui.support import Demo

CHECKOUT = Path(__file__).resolve().parents[2]
WARMING_S = 120
"""To start, to bring the program to rest twice, and to end, on busy processors."""
GROWTH = 1.10


def seen(project: Path, folder: Path, seed: int, seconds: int) -> dict[str, Any]:
    """Let the monkey play in a process of its own."""
    run = subprocess.run(
        [sys.executable, "-m", "tests.gui.monkey", str(project), str(folder),
         "--seed", str(seed), "--seconds", str(seconds)],
        cwd=CHECKOUT, capture_output=True, text=True, check=False, timeout=seconds + 2 * WARMING_S,
        env={**os.environ, "PYTHONPATH": str(CHECKOUT)},
    )  # fmt: skip
    assert run.returncode == 0, run.stderr[-5000:]
    found = json.loads((folder / "seen.json").read_text(encoding="utf-8"))
    print(json.dumps(found, indent=1, ensure_ascii=False))
    return found


@pytest.fixture
def base(demo: Demo, demo_copy: Path) -> Path:
    """A project with picked targets, on the disk."""
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    # With the raw files of its own folder, for the monkey's cage gets copies of it
    save_project(replace(open_project(demo_copy), targets=demo.picked.targets))
    return demo_copy


@pytest.mark.timeout(60 + 2 * WARMING_S)
def test_a_minute_of_anything(base: Path, tmp_path: Path) -> None:
    """Stalls are printed: how long computing takes on shared processors is no matter of a test."""
    found = seen(base, tmp_path / "cage", seed=1, seconds=60)
    assert sum(found["done"].values()) > 100, "it hardly did anything"
    assert found["exceptions"] == []
    assert found["left"] == []


@pytest.mark.long
@pytest.mark.timeout(600 + 2 * WARMING_S)
def test_ten_minutes_of_anything(base: Path, tmp_path: Path) -> None:
    found = seen(base, tmp_path / "cage", seed=2, seconds=600)
    assert sum(found["done"].values()) > 1000
    assert found["exceptions"] == []
    assert found["stalls"] == []
    assert found["left"] == []
    # Each library is loaded when it is first needed, so the first minutes are no measure
    course = found["course_mb"]
    third = len(course) // 3
    assert max(course[-third:]) < GROWTH * max(course[third : 2 * third])
