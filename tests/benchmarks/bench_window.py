"""Times of the window with an imported project: first picture, frames, a seed, and stalls.

The line has 10^7 points, with ``-m long`` 10^8. The survey is made in the folder of
LISPAC_BENCH_FOLDER, if set, and kept there for the next run. The figures are from a separate
process with a cold start of the window, without the import. A stall is printed with the processor
time of the window's thread, a frame with that of all cores: these do not grow on a busy machine.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QGuiApplication

from lispac.workflow.importing.line_import import import_lines
from lispac.workflow.project.projects import create_project, open_project
from tests.benchmarks.bench_store import make_project

BEAT_MS = 5
STALL_MS = 50


@pytest.mark.parametrize("count", [10**7, pytest.param(10**8, marks=pytest.mark.long)])
def test_open_an_imported_project(count: int, tmp_path: Path, qapp: QGuiApplication) -> None:
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    folder = Path(os.environ.get("LISPAC_BENCH_FOLDER") or tmp_path) / f"{count:.0e}"
    if not (folder / "project" / "project.json").is_file():
        folder.mkdir(parents=True, exist_ok=True)
        made = make_project(folder, count, "las")
        project = create_project(
            folder / "project", trajectory=made.trajectory, lines=made.lines, settings=made.settings
        )
        import_lines(project)
    run = subprocess.run(
        [sys.executable, "-m", "tests.benchmarks.bench_window", str(folder / "project")],
        capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2],
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    print(f"\n{count:,} points\n{run.stdout}")


def report(folder: Path) -> None:
    """Open a project in a window and print the measurements."""
    import tempfile

    from PySide6.QtWidgets import QApplication

    application = QApplication(sys.argv[:1])
    from lispac.gui.app.settings import AppSettings
    from lispac.gui.project.seed_options import SeedOptions
    from lispac.gui.viewport.base import PickedPoint
    from lispac.gui.viewport.vtk_viewport import VtkViewport
    from lispac.gui.window.main_window import MainWindow

    viewport = VtkViewport()
    settings = AppSettings(Path(tempfile.mkdtemp()) / "settings.ini")
    window = MainWindow(viewport, settings)
    window.resize(1600, 1000)
    window.show()
    application.processEvents()
    beats: list[tuple[float, float]] = []
    heart = QTimer()
    heart.timeout.connect(lambda: beats.append((time.perf_counter(), time.thread_time())))
    heart.start(BEAT_MS)

    def until(done) -> float:
        beats.clear()
        start = time.perf_counter()
        while not done():
            application.processEvents()
            time.sleep(0.001)
        return time.perf_counter() - start

    def stall() -> str:
        gaps = 1000 * np.diff(beats, axis=0)
        longest, own = gaps[np.argmax(gaps[:, 0])]
        late = (gaps[:, 0] > STALL_MS).sum()
        return (
            f"longest stall {longest:.0f} ms ({own:.0f} of them computing; {late} over {STALL_MS})"
        )

    def timed(function, rounds: int) -> str:
        took = []
        for _ in range(rounds):
            start = time.perf_counter(), time.process_time()
            function()
            took.append((time.perf_counter() - start[0], time.process_time() - start[1]))
        clock, cores = 1000 * np.array(took).T
        middle = f"{np.median(clock):.0f} ms" if rounds > 1 else f"{clock[0]:.0f} ms"
        return f"{middle} (least {clock.min():.0f}, processor {np.median(cores):.0f})"

    until(lambda: viewport.canvas.isVisible())
    end = time.perf_counter() + 2.0
    until(lambda: time.perf_counter() > end)
    print(f"  an idle window: {stall()}")
    window.open_project(folder)
    took = until(lambda: window.document.survey is not None and not window.runner.active)
    viewport.canvas.grabFramebuffer()
    print(f"  survey shown after {took:.2f} s; {stall()}")
    survey = window.document.survey
    assert survey is not None
    name = survey.lines[0]
    sample = survey.clouds[name].sample
    middle = sample[np.argmin(np.linalg.norm(sample - np.median(sample, axis=0), axis=1))]
    for state in ("first", "second"):
        point = PickedPoint(name, (float(middle[0]), float(middle[1]), float(middle[2])))
        window.controller.seed(point, SeedOptions(line=name))
        took = until(lambda: not window.runner.active)
        found = window.controller.candidate
        points = 0 if found is None else len(found.sightings[0].indices)
        print(f"  {state} seed on it {took:.2f} s, {points:,} points; {stall()}")
        window.controller.reject()

    def moved() -> None:
        viewport._navigator.mouse.rotated.emit(3.0, 0.0)
        viewport.canvas.grabFramebuffer()

    def rested() -> None:
        viewport._navigator.mouse.rotated.emit(3.0, 0.0)
        viewport._view_detail.compute_now(viewport._refinement_steps(viewport._times.rest_points))
        viewport.canvas.grabFramebuffer()

    viewport.fit()
    moved()
    print(f"  frame while moving {timed(moved, 21)}")
    print(f"  picture at rest {timed(rested, 5)}")
    window.actions_["hover"].trigger()
    until(lambda: not window.runner.active)
    viewport._sketch_layer._mouse_position = tuple(viewport.to_pixels(middle[None])[0])
    print(f"  hover preview {timed(viewport._sketch_layer._emit_hovered, 21)}")
    assert "hover" in viewport._sketch_layer._sketches
    assert open_project(folder).lines
    window.close()


if __name__ == "__main__":
    report(Path(sys.argv[1]))
