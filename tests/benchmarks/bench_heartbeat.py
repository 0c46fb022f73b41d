"""Responsiveness of the window in a complete workflow.

A separate process goes from the raw files to the preview of the report, in the real window with its
dialogues, on a screen. A timer fires every 10 ms on the window's thread; for each step, the longest
pause, the longest computing time and the 99th percentile of the pauses are printed. The rest of a
pause is drawing (slow without a graphics card) and waiting for a processor (on a busy machine).
Aim: no computing of more than 200 ms.
"""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QGuiApplication
from PySide6.QtWidgets import QApplication, QWidget

from lispac.project import Project
from tests.gui.pulse import Draws, Pulse, timed_viewport
from tests.gui.support import show_panel

CHECKOUT = Path(__file__).resolve().parents[2]
LONG_MS = 200.0
TIMEOUT_S = 300.0


@pytest.mark.timeout(900)
def test_the_window_keeps_up(tmp_path: Path, whole_demo: Project) -> None:
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    home = tmp_path / "home"
    home.mkdir()
    run = subprocess.run(
        [sys.executable, "-m", "tests.benchmarks.bench_heartbeat", whole_demo.folder,
         tmp_path / "made"],
        capture_output=True, text=True, check=False, cwd=CHECKOUT,
        env={
            **os.environ, "PYTHONPATH": str(CHECKOUT), "HOME": str(home),
            "XDG_CACHE_HOME": str(home), "XDG_CONFIG_HOME": str(home),
        },
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    for step, summary in json.loads(run.stdout.splitlines()[-1]).items():
        print(f"\n  {step}: {summary}", end="")
    print()


# -- in the process --------------------------------------------------------------------------------


class BeatRecorder(Pulse):
    """Records every beat: wall-clock time and computing time, ms."""

    def discard(self) -> None:
        """Clear all measurements."""
        self.beaten: list[tuple[float, float]] = []
        super().discard()

    def _beat(self) -> None:
        before = self._last
        super()._beat()
        took, _drawn, computed, _waited = np.subtract(self._last, before)
        self.beaten.append((1000 * took, 1000 * computed))

    def summary(self) -> str:
        """Text with the longest pause, the 99th percentile, and the places of long computing."""
        took, computed = np.array(self.beaten).T
        late = [pause for pause in self.pauses if pause.computing > self.limit]
        return (
            f"longest pause {took.max():.0f} ms, longest computing {computed.max():.0f} ms, "
            f"99 % of {len(took)} beats within {np.percentile(took, 99):.0f} ms, "
            f"{len(late)} over {self.limit:.0f} ms of computing"
            + "".join(f"\n    {pause}" for pause in late)
        )


class Workflow:
    """Steps of a user's workflow, with a summary of the pauses in each step."""

    def __init__(self, application: QApplication, session: Any, heart: BeatRecorder) -> None:
        self._application, self._window, self._heart = application, session.window, heart
        self.summaries: dict[str, str] = {}

    def until(self, done: Callable[[], bool]) -> None:
        """Process events until a condition holds."""
        limit = time.monotonic() + TIMEOUT_S
        while not done():
            self._application.processEvents()
            time.sleep(0.0005)
            if time.monotonic() > limit:
                raise TimeoutError(
                    f"after {list(self.summaries)}: {QApplication.activeModalWidget()}"
                )

    def idle(self) -> bool:
        """Whether no task is active and no result is awaited."""
        return not self._window.runner.active and not self._window.document.awaits_result

    def step(
        self,
        name: str,
        act: Callable[[], object],
        done: Callable[[], bool] | None = None,
        on_dialog: Callable[[Any], object] | None = None,
    ) -> None:
        """Perform a step and summarise the beats until it is done and the window is idle.

        Parameters
        ----------
        done : whether the step is done; `idle` by default
        on_dialog : called every 100 ms with the open dialogue
        """
        self._heart.discard()
        begun = time.monotonic()
        answering = QTimer(interval=100)
        if on_dialog is not None:
            answering.timeout.connect(
                lambda: (dialog := QApplication.activeModalWidget()) and on_dialog(dialog)
            )
            answering.start()
        act()
        self.until(done or self.idle)
        answering.stop()
        took = time.monotonic() - begun
        rested = time.monotonic() + 1.0  # time to draw the detail and to update the panels
        self.until(lambda: time.monotonic() > rested)
        beats = self._heart.beats
        self.until(lambda: self._heart.beats > beats)  # the beat that ends the last pause
        self.summaries[name] = f"{took:.1f} s; {self._heart.summary()}"


def drop(widget: QWidget, paths: Sequence[Path]) -> None:
    """Send the events of a file drop to a widget."""
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    how = Qt.DropAction.CopyAction, mime, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(widget, QDragEnterEvent(QPoint(20, 20), *how))
    QApplication.sendEvent(widget, QDropEvent(QPointF(20, 20), *how))


def walk(raw: Path, folder: Path) -> dict[str, str]:
    """Import, pick, estimate, validate and preview the report; a summary of each step."""
    application = QApplication(sys.argv[:1])
    application.setQuitOnLastWindowClosed(False)
    from lispac.gui.app.garbage_collection import GuiThreadGarbageCollector
    from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
    from lispac.gui.viewport.base import PickedPoint
    from lispac.gui.window.session import Session
    from lispac.workflow.planning.demo import demo_seeds
    from lispac.workflow.project.projects import open_project

    draws = Draws()
    tidying = GuiThreadGarbageCollector(application)
    session = Session(application, timed_viewport(draws))
    window = session.window
    heart = BeatRecorder(LONG_MS, draws)
    heart.start()
    workflow = Workflow(application, session, heart)

    project = open_project(raw)
    assert project.accuracy is not None
    files = [project.trajectory, project.accuracy, *(line.path for line in project.lines)]

    def fill(dialog: QWidget) -> None:
        """Type a folder once every file has been examined, and accept the dialogue."""
        if isinstance(dialog, ImportDialog) and not dialog.work.busy:
            if dialog.folder.text() != str(folder):
                dialog.folder.setText(str(folder))
                dialog.folder.textEdited.emit(str(folder))
            dialog.ok.click()

    workflow.step("an idle window", lambda: None, lambda: True)
    workflow.step(
        "import, files dropped on the window", lambda: drop(window, files),
        lambda: window.document.survey is not None and workflow.idle(), fill,
    )  # fmt: skip
    window.document.undo_stack.setClean()
    # The project with the boresight and lever arm that a surveyor enters
    workflow.step("opening the project", lambda: window.open_project(raw))
    first = window.document.survey.lines[0]
    for name, (role, position) in demo_seeds().items():
        window.targets.set_role(role)
        clicked_point = PickedPoint(first, position)
        workflow.step(
            f"seed on {name}",
            lambda clicked_point=clicked_point: window.viewport.signals.seed_clicked.emit(
                clicked_point
            ),
        )
        workflow.step(f"{name} accepted", window.actions_["accept"].trigger)
    workflow.step("estimate", window.actions_["estimate"].trigger)
    workflow.step("validate", window.actions_["validate"].trigger)
    for title in (*window.docks, *window.panel_windows):
        workflow.step(f"{title} looked at", lambda title=title: show_panel(window, title))
    pages = window.diagnostics.list
    for k in range(pages.count()):
        workflow.step(f"diagnostics, {pages.item(k).text()}", lambda k=k: pages.setCurrentRow(k))
    previewed: list[QWidget] = []

    def leave(dialog: QWidget) -> None:
        previewed.append(dialog)
        dialog.reject()

    workflow.step(
        "report, to its preview", window.report.preview.click, lambda: bool(previewed), leave
    )
    workflow.step("saved", window.actions_["save"].trigger)
    heart.stop()
    tidying.end()
    window.document.undo_stack.setClean()
    window.close()
    return workflow.summaries


if __name__ == "__main__":
    print(json.dumps(walk(Path(sys.argv[1]), Path(sys.argv[2]))))
