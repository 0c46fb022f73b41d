"""Fixtures every test may use."""

import gc
import os
import shutil
from collections import Counter
from collections.abc import Generator
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

import hypothesis
import pytest

from lispac.cli.main import main
from lispac.project import Project
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.workflow.planning.demo import make_demo
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.sharing import once

hypothesis.settings.register_profile("same", derandomize=True, deadline=None)

# Warnings are errors in the processes that tests start too, but for the deprecations of libraries.
os.environ["PYTHONWARNINGS"] = "error::RuntimeWarning,error::UserWarning"

LONG = {"test_gui_monkey.py": 40, "test_gui_end_to_end.py": 30, "test_coverage.py": 30}
"""Files of one or a few long tests: as many short ones take as long."""


def pytest_configure(config: pytest.Config) -> None:
    """The normal run draws the same examples every time; the long one seeks new ones."""
    if config.option.markexpr == "not long":
        hypothesis.settings.load_profile("same")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Where two processes share the files, long ones come before the many short ones.

    One that begins last of all leaves the other process without work for as long as it takes.
    """
    if "PYTEST_XDIST_WORKER" in os.environ:
        tests = Counter(item.path for item in items)
        items.sort(key=lambda item: -max(tests[item.path], LONG.get(item.path.name, 0)))


def pytest_collection_finish() -> None:
    """Modules and tests stay to the end: no search for garbage has to go through them each time."""
    gc.collect()
    gc.freeze()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """As in the program, no worker deletes widgets: what a window leaves is collected after it.

    Around the whole of a test, for its fixtures are held until it has ended. Frozen before, so that
    this takes no longer than what the test has made.
    """
    if "qapp" not in getattr(item, "fixturenames", ()):
        return (yield)
    from tests.leaked_resources import find_leaks

    gc.disable()
    gc.freeze()
    try:
        ended = yield
        if left := find_leaks():
            _fail(item, "left behind: " + ", ".join(left))
        return ended
    finally:
        gc.enable()


def _fail(item: pytest.Item, why: str) -> None:
    report = pytest.TestReport(
        item.nodeid, item.location, {}, outcome="failed", longrepr=why, when="teardown"
    )
    item.ihook.pytest_runtest_logreport(report=report)


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of the reference surveys, which live beside the checkout and are not part of it."""
    folder = Path(__file__).resolve().parents[2] / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("the reference surveys are not beside this checkout")
    return folder


@pytest.fixture(scope="session")
def port(tmp_path_factory: pytest.TempPathFactory) -> SimulatedSurvey:
    """The built-in survey as it is simulated, every point with its label."""
    return once(tmp_path_factory, "port", lambda _folder: port_survey())


@pytest.fixture(scope="session")
def whole_demo(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The built-in survey with nothing picked; not to be changed on disk."""
    return once(tmp_path_factory, "whole", make_demo)


@pytest.fixture(scope="session")
def demo_project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The same with a third of the points, where their number does not matter."""
    return once(
        tmp_path_factory, "made", lambda folder: make_demo(folder, points_per_second=50_000.0)
    )


@pytest.fixture(scope="session")
def sparse_project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The same with a sixth of the points: to look for surfaces takes as long as they are many."""
    return once(
        tmp_path_factory, "sparse", lambda folder: make_demo(folder, points_per_second=25_000.0)
    )


@pytest.fixture(scope="session")
def printed_demo(
    demo_project: Project, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Path, int, str, str]:
    """Folder of `lispac demo`, its code and what it said; not to be changed on disk."""

    def run_demo(folder: Path) -> tuple[Path, int, str, str]:
        shutil.copytree(demo_project.folder, folder)
        left = b"left by an earlier run, which the next one replaces"
        (folder / "raw" / "L1_000.laz").write_bytes(left)
        with redirect_stdout(StringIO()) as out, redirect_stderr(StringIO()) as err:
            code = main(["demo", "--output", str(folder), "--no-window"])
        return folder, code, out.getvalue(), err.getvalue()

    return once(tmp_path_factory, "printed", run_demo)


@pytest.fixture(scope="session")
def calibrated(
    printed_demo: tuple[Path, int, str, str], tmp_path_factory: pytest.TempPathFactory
) -> tuple[Project, Survey]:
    """The built-in survey, calibrated and validated; not to be changed on disk."""

    def take(folder: Path) -> Project:
        shutil.copytree(printed_demo[0], folder, ignore=shutil.ignore_patterns("report.*"))
        return open_project(folder)

    project = once(tmp_path_factory, "calibrated", take)
    return project, load_survey(project)


@pytest.fixture
def copy(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """A copy of the calibrated project, to do with as one likes."""
    folder = tmp_path / "copy"
    shutil.copytree(calibrated[0].folder, folder)
    return open_project(folder)


@pytest.fixture
def shown(qtbot):
    """Show viewports, each with the budget asked for, and take them away at the end."""
    from PySide6.QtCore import QCoreApplication, QEvent
    from PySide6.QtGui import QGuiApplication

    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    views = []

    def show(budget=None):
        view = VtkViewport(budget=budget)
        views.append(view)
        view.widget.resize(800, 600)
        view.widget.show()
        qtbot.waitExposed(view.widget)
        return view

    yield show
    for view in views:
        view.close()
        view.widget.close()
        view.widget.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def viewport(shown):
    return shown()
