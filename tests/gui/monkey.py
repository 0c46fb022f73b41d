"""Monkey test of the window: random actions by mouse and keys for a given time.

    python -m tests.gui.monkey PROJECT FOLDER --seconds 60 --seed 1

The program runs as for a user, with its own dialogues, but its home directory and all files that
the monkey names are in FOLDER; PROJECT is copied there. The findings go to FOLDER/seen.json, the
log of actions to FOLDER/did.txt while it runs. The same seed makes the same choices on the same
screen, but background tasks end at different times, so two runs diverge sooner or later.
"""

import argparse
import faulthandler
import gc
import json
import logging
import os
import random
import shutil
import sys
import threading
import time
import traceback
from collections import Counter, deque
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, QEvent, QEventLoop, QObject, Qt, QTimer, QUrl, Slot
from PySide6.QtGui import QDesktopServices
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QDialog, QMessageBox

from lispac.report.pdf import write_pdf
from tests.gui.monkey_hands import Doing, Hands
from tests.gui.pulse import Draws, Pulse, resident_mb, timed_viewport
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

STEP_MS = 12
STALL_MS = 200.0
ACTION_TIMEOUT_S = 0.25
HANG_LIMIT_S = 150.0
"""Time without an event after which the process dumps the stacks of its threads and exits."""
NO_DRAG_PX = 100_000
MAX_REPETITIONS = 100
"""Successive repetitions of one action that are reported as an error."""
DEMO = "harbour"


@dataclass
class Findings:
    """Findings of a run; all lists except the measurements should be empty.

    Attributes
    ----------
    done : number of actions of each kind
    exceptions : tracebacks of unexpected errors, each with the actions before it
    refusals : number of occurrences of each error message of the program
    warnings : number of occurrences of each warning, mainly of Qt
    stalls : pauses with more than 200 ms of computing in the window's thread
    computing_ms : computing time of each stall
    drawn : other pauses over 200 ms: VTK was drawing, or other processes had the processors
    renewed : pauses in which a window was replaced by a new one
    memory_mb, widgets : before and after the run, with the program in the same state
    course_mb : memory during the run, at least ten seconds apart, while no task is active
    left : threads and windows that remain after the end
    """

    done: Counter[str] = field(default_factory=Counter)
    exceptions: list[str] = field(default_factory=list)
    refusals: Counter[str] = field(default_factory=Counter)
    warnings: Counter[str] = field(default_factory=Counter)
    stalls: list[str] = field(default_factory=list)
    computing_ms: list[float] = field(default_factory=list)
    drawn: list[str] = field(default_factory=list)
    renewed: list[str] = field(default_factory=list)
    longest_ms: float = 0.0
    memory_mb: list[float] = field(default_factory=list)
    course_mb: list[float] = field(default_factory=list)
    widgets: list[int] = field(default_factory=list)
    left: list[str] = field(default_factory=list)


class Records(logging.Handler):
    """Log handler that sorts the logged errors and warnings into the findings."""

    def __init__(self, monkey: "Monkey") -> None:
        super().__init__(logging.WARNING)
        self._monkey = monkey

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        text = record.getMessage()
        if error is not None:
            if isinstance(error, OSError) and error.strerror:
                self._monkey.findings.refusals[text] += 1
            else:
                self._monkey.caught("".join(traceback.format_exception(error)))
        elif text.startswith("Qt:"):
            self._monkey.findings.warnings[text] += 1
            if record.levelno >= logging.ERROR:
                self._monkey.caught(text)
        elif record.levelno >= logging.ERROR:
            self._monkey.findings.refusals[text] += 1
        else:
            self._monkey.findings.warnings[text] += 1


class Links(QObject):
    """Handler of URLs that would otherwise open another program."""

    @Slot(QUrl)
    def follow(self, _url: QUrl) -> None:
        """Ignore the URL."""


class Monkey(QObject):
    """Performs an action every few milliseconds, also while a dialogue is open."""

    def __init__(self, session: Any, folder: Path, seed: int, draws: Draws) -> None:
        super().__init__()
        self.session, self.folder = session, folder
        self.findings = Findings()
        self._hands = Hands(random.Random(seed), folder)
        self._lately: deque[str] = deque(maxlen=12)
        self._doing: Doing | None = None
        self._since, self._inside = 0.0, 0
        self._diary = (folder / "did.txt").open("w", encoding="utf-8", buffering=1)
        self._until = 0.0
        self.ending = False
        self.pulse = Pulse(STALL_MS, draws)
        self._reported_pauses, self._again = 0, 0
        self._window = session.window

    # -- findings --------------------------------------------------------------------------------

    def caught(self, text: str) -> None:
        self.findings.exceptions.append("\n".join([*self._lately, text]))
        self._diary.write(f"!!! {text}\n")

    def note_pauses(self) -> None:
        """Sort the pauses since the last call into the findings."""
        pauses = self.pulse.pauses
        for pause in pauses[self._reported_pauses :]:
            text = f"{pause}\n      after: {' | '.join(list(self._lately)[-4:])}"
            made = any("_made" in place or "session.py" in place for place in pause.places)
            if made or self.session.window is not self._window:
                self.findings.renewed.append(text)
            elif pause.computing > STALL_MS:
                self.findings.stalls.append(text)
                self.findings.computing_ms.append(pause.computing)
            else:
                self.findings.drawn.append(text)
            self._diary.write(f"--- {text}\n")
        self._reported_pauses = len(pauses)
        self._window = self.session.window

    # -- actions ---------------------------------------------------------------------------------

    def play(self, seconds: float, least: int = 0) -> None:
        """Perform random actions for some seconds, then wait until nothing runs.

        Parameters
        ----------
        least : int
            Number of actions for which it goes on after this time, on busy processors.
        """
        self._until, self._least = time.monotonic() + seconds, least
        self._weighed = 0.0
        self.ending = False
        self.pulse.skip()
        self._tick()
        while not self._rests():
            QCoreApplication.processEvents()
            time.sleep(0.001)

    def _tick(self) -> None:
        faulthandler.dump_traceback_later(HANG_LIMIT_S, exit=True)
        self.note_pauses()
        # Temporary memory of a search (gigabytes for a target of 45 m) is not growth
        if time.monotonic() > self._weighed + 10 and not self._works():
            self._weighed = time.monotonic()
            self.findings.course_mb.append(round(resident_mb(), 1))
        if time.monotonic() > self._until and sum(self.findings.done.values()) >= self._least:
            self.ending = True
            if self._rests() and not self._inside:
                return
        QTimer.singleShot(STEP_MS, self._tick)
        doing = self._doing
        if doing is not None and doing.gi_running:  # type: ignore[attr-defined]
            # The action is not finished; it may have opened a dialogue or a menu that needs input
            if time.monotonic() - self._since < ACTION_TIMEOUT_S:
                return
            doing = None
            window = QApplication.activeWindow()
            if len(self._hands.front()) > 0 and not self._waits() and window is not None:
                doing = self._hands.press(window, "Escape")  # ends the drag of a text
        self._since = time.monotonic()
        if doing is None or self.ending:
            doing = self._doing = self._end() if self.ending else self._hands.doing()
            if doing is None:
                if not self.session.window.isVisible():  # closed: replace it by a new window
                    closed = self.session.window
                    self.session.window = self.session._made(None)
                    closed.deleteLater()
                return
        first = not self._hands.did
        self._inside += 1
        try:
            next(doing)
        except StopIteration:
            if self._doing is doing:
                self._doing = None
        except RuntimeError as error:
            if "already deleted" not in str(error):
                raise
            self._doing = None
        finally:
            self._inside -= 1
        if first and self._hands.did and not self.ending:
            self._again = self._again + 1 if self._hands.did in list(self._lately)[-1:] else 0
            if self._again == MAX_REPETITIONS:
                self.caught(f"{MAX_REPETITIONS} times the same")
            self._lately.append(self._hands.did)
            self.findings.done[self._hands.did.split(" ")[0]] += 1
            self._diary.write(f"{self._hands.did}\n")

    def _end(self) -> Iterator[None]:
        """Close dialogues with Escape or a random button, and cancel the running tasks."""
        front = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if front is None:
            for runner in self._runners():
                if runner.busy:  # cancelled background tasks would only be started again
                    runner.cancel()
            yield
            return
        if isinstance(front, QDialog) and not self._hands.chance.randrange(3):
            buttons = [b for b in front.findChildren(QAbstractButton) if b.isVisible()]
            if buttons:
                button = self._hands.chance.choice(buttons)
                self._hands.click(button, button.rect().center())
        elif (handle := front.windowHandle()) is not None:
            QTest.keyClick(handle, Qt.Key.Key_Escape)
        yield

    def _runners(self) -> list[Any]:
        window = self.session.window
        return [window.runner, window.site_design.runner, window.site_design.field_plan_runner]

    @staticmethod
    def _waits() -> bool:
        """Whether a menu or a modal dialogue is open."""
        return bool(QApplication.activePopupWidget() or QApplication.activeModalWidget())

    def _rests(self) -> bool:
        """Whether the time is over, no dialogue is open and no visible task runs."""
        return (
            self.ending and not self._waits() and not any(runner.busy for runner in self._runners())
        )

    def _works(self) -> bool:
        """Whether any task runs or waits."""
        return any(runner.active for runner in self._runners())

    def rest(self) -> None:
        """Wait until no task is active, at most two minutes."""
        until = time.monotonic() + 120
        while time.monotonic() < until:
            QCoreApplication.processEvents()
            time.sleep(0.001)
            if not self._works():
                break

    def stand(self, project: Path) -> None:
        """Open, estimate and validate a project, then record memory and number of widgets."""
        faulthandler.dump_traceback_later(HANG_LIMIT_S, exit=True)
        window = self.session.window
        if (design := window.site_design.window) is not None:
            design.hide()
        window.document.open(None, None)
        window.open_project(project)
        wait(100)
        self.rest()
        for name in ("estimate", "validate"):
            window.actions_[name].trigger()
            wait(100)
            self.rest()
        wait(500)
        self.rest()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        gc.collect()
        wait(100)
        self.findings.memory_mb.append(round(resident_mb(), 1))
        self.findings.widgets.append(len(QApplication.allWidgets()))


def main() -> int:
    """Run the monkey and write its findings."""
    parser = argparse.ArgumentParser()
    parser.add_argument("project", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--actions", type=int, default=0, help="least number of actions")
    parser.add_argument(
        "--no-memory", action="store_true", help="do not prepare the comparison of memory"
    )
    options = parser.parse_args()
    folder = options.folder.resolve()
    home, here = folder / "home", folder / "here"
    for each in (home, here, folder / "written"):
        each.mkdir(parents=True)
    project = folder / DEMO
    shutil.copytree(options.project, project)
    # The monkey may open and overwrite "away"; memory is measured with a copy out of its reach
    for each in (folder / "away", home / "compared"):
        shutil.copytree(options.project, each)
    os.environ["HOME"] = str(home)
    for name in ("CACHE", "CONFIG", "DATA"):
        os.environ[f"XDG_{name}_HOME"] = str(home / name.lower())
    os.chdir(here)

    QApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    application = QApplication(sys.argv[:1])
    application.setQuitOnLastWindowClosed(False)
    # A drag of text, or of a file in a dialogue, ends only with the real mouse: allow no such drags
    application.setStartDragDistance(NO_DRAG_PX)
    links = Links()
    for scheme in ("file", "http", "https"):
        QDesktopServices.setUrlHandler(scheme, links, "follow")
    from lispac.gui.app.garbage_collection import GuiThreadGarbageCollector
    from lispac.gui.app.log_file import LOGGER, LogFile
    from lispac.gui.app.settings import AppSettings
    from lispac.gui.project import controller
    from lispac.gui.window.session import Session

    controller.demo_folder = lambda: project
    draws = Draws()
    viewport = timed_viewport(draws)
    settings = AppSettings(home / "window.ini")
    tidying = GuiThreadGarbageCollector(application)
    session = Session(application, viewport, settings)
    logbook = LogFile(session.log_folder, session.report_uncaught)
    logbook.begin()
    monkey = Monkey(session, folder, options.seed, draws)
    # The first report allocates 250 MB permanently (fonts, caches of Typst), later reports nothing:
    # make one before the first measurement, or it looks like growth
    if not options.no_memory:
        sample = sample_content(sample_project(home / "sample"))
        write_pdf(sample, home / "sample.pdf", {}, FULL_REPORT)
    for logger in (LOGGER, logging.getLogger("py.warnings")):
        logger.addHandler(Records(monkey))
    sys.unraisablehook = lambda known: monkey.caught(
        "".join(traceback.format_exception(known.exc_value)) if known.exc_value else str(known)
    )
    monkey.stand(home / "compared")
    monkey.pulse.start()
    monkey.play(options.seconds, options.actions)
    monkey.note_pauses()
    monkey.pulse.stop()
    findings = monkey.findings
    findings.longest_ms = monkey.pulse.longest
    monkey.session.window.document.undo_stack.setClean()
    monkey.stand(home / "compared")
    end(monkey)
    faulthandler.cancel_dump_traceback_later()
    logbook.end()
    tidying.end()
    (folder / "seen.json").write_text(json.dumps(vars(findings), indent=1, ensure_ascii=False))
    return 0


def wait(ms: int) -> None:
    """Run the event loop; `QTest.qWait` would hold the GIL and block the worker threads."""
    loop = QEventLoop()
    QTimer.singleShot(ms, loop.quit)
    loop.exec()


def end(monkey: Monkey) -> None:
    """Close the window as a user does, and record the threads and windows that remain."""
    faulthandler.dump_traceback_later(HANG_LIMIT_S, exit=True)
    window = monkey.session.window
    letting_go = QTimer(interval=200)
    letting_go.timeout.connect(_discard)
    letting_go.start()
    while not window.close():
        wait(100)
    letting_go.stop()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    wait(1000)
    gc.collect()
    monkey.findings.left = [
        *(t.name for t in threading.enumerate() if t.name.startswith(("lispac", "pulse"))),
        *(type(w).__name__ for w in QApplication.topLevelWidgets() if w.isVisible()),
    ]


def _discard() -> None:
    box = QApplication.activeModalWidget()
    if isinstance(box, QMessageBox):
        button = box.button(QMessageBox.StandardButton.Discard) or box.buttons()[-1]
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)


if __name__ == "__main__":
    sys.exit(main())
