"""Start time of the program, alone and with a project, and its memory while idle.

Each figure is from a separate process, started as by a user; bytecode and compiled kernels exist
from an earlier start. Aims on two cores: a splash screen within 0.5 s and
a usable window within 1.5 s.
"""

import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtGui import QGuiApplication, QIcon

from lispac.project import Project

CHECKOUT = Path(__file__).resolve().parents[2]
ROUNDS = 5
UNITS = {
    "splash_s": "s", "window_s": "s", "window_cpu_s": "s of processor", "project_s": "s",
    "project_cpu_s": "s of processor", "memory_mb": "MB",
}  # fmt: skip
"""Units of the measurements; the processor time does not depend on other programs."""


@pytest.fixture(autouse=True)
def screen(qapp: QGuiApplication) -> None:
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")


def measurements_of(tmp_path: Path, what: str, *words: str | Path) -> dict[str, Any]:
    """Run this file in a separate process and return its measurements."""
    home = tmp_path / "home"  # the same for all rounds, as for a user
    home.mkdir(exist_ok=True)
    variables = {
        **os.environ, "PYTHONPATH": str(CHECKOUT), "XDG_CACHE_HOME": str(home), "HOME": str(home),
        "NUMBA_CACHE_DIR": os.environ.get("NUMBA_CACHE_DIR", str(tmp_path / "numba")),
        "MPLCONFIGDIR": os.environ.get("MPLCONFIGDIR", str(tmp_path / "fonts")),
        "PYTHONPYCACHEPREFIX": os.environ.get("PYTHONPYCACHEPREFIX", str(tmp_path / "bytecode")),
    }  # fmt: skip
    variables.pop("PYTHONDONTWRITEBYTECODE", None)
    run = subprocess.run(
        [sys.executable, "-m", "tests.benchmarks.bench_program", what, f"{time.time()!r}",
         *map(str, words)],
        capture_output=True, text=True, check=False, cwd=CHECKOUT, env=variables,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout.splitlines()[-1])


@pytest.mark.parametrize("opening", [False, True], ids=["alone", "with the demo"])
def test_start(opening: bool, tmp_path: Path, denser_calibrated: tuple[Project, object]) -> None:
    words = [denser_calibrated[0].folder] if opening else []
    runs = [measurements_of(tmp_path, "start", *words) for _ in range(ROUNDS + 1)][1:]
    for key, unit in UNITS.items():
        values = [run[key] for run in runs if key in run]
        if values:
            middle = statistics.median(values)
            print(f"\n  {key}: {middle:.2f} {unit} (least {min(values):.2f})", end="")
    print()


# -- in the process --------------------------------------------------------------------------------


def processor_s() -> float:
    """Processor time of this process, s, in all threads."""
    times = os.times()
    return times.user + times.system


def start(began: float, words: list[str]) -> None:
    """Run the program until its window is usable, and close it."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication, QLabel

    from lispac.gui.window import program

    run, found = QApplication.exec, {}
    show_splash_screen = program.show_splash_screen

    def show_and_note(icon: QIcon) -> QLabel:
        splash = show_splash_screen(icon)
        found["splash_s"] = time.time() - began
        return splash

    program.show_splash_screen = show_and_note

    def inspect_window() -> None:
        from lispac.gui.window.main_window import MainWindow

        window = next(w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow))
        handle = window.windowHandle()
        if handle is None or not handle.isExposed():
            return
        found.setdefault("window_s", time.time() - began)
        found.setdefault("window_cpu_s", processor_s())
        if words and (window.document.survey is None or window.runner.active):
            return
        if words:
            found.setdefault("project_s", time.time() - began)
            found.setdefault("project_cpu_s", processor_s())
        timer.stop()
        QTimer.singleShot(3000, lambda: leave(window))

    def leave(window: Any) -> None:
        from tests.gui.pulse import resident_mb

        found["memory_mb"] = resident_mb()
        window.close()

    timer = QTimer()
    timer.timeout.connect(inspect_window)

    def exec_() -> int:
        timer.start(10)  # an interval of 0 would slow down the import of the viewport
        return run()

    QApplication.exec = staticmethod(exec_)
    sys.argv[1:] = words
    program.main(words)
    print(json.dumps(found))


if __name__ == "__main__":
    start(float(sys.argv[2]), sys.argv[3:])
