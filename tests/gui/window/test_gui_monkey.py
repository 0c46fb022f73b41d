"""Monkey tests of the window: no exception, no memory growth, nothing left behind."""

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

CHECKOUT = Path(__file__).resolve().parents[3]
WARMING_S = 120
"""Time for starting, for both memory measurements and for closing, on busy processors."""
MAX_GROWTH = 1.10


def run_monkey(
    project: Path, folder: Path, seed: int, seconds: int, *options: str
) -> dict[str, Any]:
    """Run the monkey in its own process and return its findings."""
    run = subprocess.run(
        [sys.executable, "-m", "tests.gui.monkey", str(project), str(folder),
         "--seed", str(seed), "--seconds", str(seconds), *options],
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
    # It refers to the raw files in its own folder, because the monkey works on copies of the folder
    save_project(replace(open_project(demo_copy), targets=demo.picked.targets))
    return demo_copy


@pytest.mark.timeout(60 + 2 * WARMING_S)
def test_five_seconds_of_random_actions(base: Path, tmp_path: Path) -> None:
    """Stalls are only printed, because computing times on shared processors vary."""
    found = run_monkey(base, tmp_path / "cage", 1, 5, "--no-memory", "--actions=11")
    assert sum(found["done"].values()) > 10, "it hardly did anything"
    assert found["exceptions"] == []
    assert found["left"] == []


@pytest.mark.long
@pytest.mark.timeout(600 + 2 * WARMING_S)
def test_ten_minutes_of_random_actions(base: Path, tmp_path: Path) -> None:
    found = run_monkey(base, tmp_path / "cage", 2, 600)
    assert sum(found["done"].values()) > 1000
    assert found["exceptions"] == []
    assert found["stalls"] == []
    assert found["left"] == []
    # Libraries are loaded when first needed, so memory is compared after the first minutes
    course = found["course_mb"]
    third = len(course) // 3
    assert max(course[-third:]) < MAX_GROWTH * max(course[third : 2 * third])
