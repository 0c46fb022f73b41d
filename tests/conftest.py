"""Fixtures and hooks for all tests."""

import gc
import os
import shutil
from collections import Counter
from collections.abc import Generator
from contextlib import redirect_stderr, redirect_stdout
from functools import partial
from io import StringIO
from pathlib import Path

import hypothesis
import pytest

from lispac.cli.main import main
from lispac.installation_paths import resource_path
from lispac.project import Project
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.workflow.output.manual import build_manual
from lispac.workflow.planning.demo import calibrate_demo, make_demo
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.sharing import make_once

hypothesis.settings.register_profile("same", derandomize=True, deadline=None)

# Warnings are errors in child processes too, except for deprecation warnings of libraries.
os.environ["PYTHONWARNINGS"] = "error::RuntimeWarning,error::UserWarning"

LONG_FILES = {
    "test_absolute.py", "test_campaign.py", "test_cli_acceptance.py", "test_cli_noise.py",
    "test_cloud.py", "test_coverage.py", "test_gui_adjust.py", "test_gui_assumed.py",
    "test_gui_diagnostics.py", "test_gui_first_use.py", "test_gui_french.py",
    "test_gui_histograms.py", "test_gui_layout.py", "test_gui_manual.py", "test_gui_monkey.py",
    "test_gui_point_readout.py", "test_gui_proposal.py", "test_gui_script.py",
    "test_gui_tour_by_hand.py", "test_gui_tutorial.py", "test_gui_typed_values.py",
    "test_gui_view_state.py", "test_gui_warnings.py", "test_kill.py", "test_natural_scenes.py",
    "test_omitted.py", "test_proposed_targets.py", "test_report_options.py",
    "test_report_pages.py", "test_script.py", "test_scripting.py", "test_targetless.py",
    "test_two_programs.py",
}  # fmt: skip
"""Files with a few long tests, which take as long as `LONG_FILE_TESTS` short ones."""
LONG_FILE_TESTS = 40

DEMO_PULSES = 25_000.0
"""Pulses per second of the built-in survey in tests that do not need all of its points."""


def pytest_configure(config: pytest.Config) -> None:
    """Draw the same examples in every normal run, and new ones in long runs."""
    if config.option.markexpr == "not long":
        hypothesis.settings.load_profile("same")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run long files first if several processes share the files.

    A long file that starts last would leave the other process without work.
    """
    if "PYTEST_XDIST_WORKER" in os.environ:
        tests = Counter(item.path for item in items)
        least = dict.fromkeys(LONG_FILES, LONG_FILE_TESTS)
        items.sort(key=lambda item: -max(tests[item.path], least.get(item.path.name, 0)))


def pytest_collection_finish() -> None:
    """Exclude modules and tests, which exist until the end, from garbage collection.

    Tests that read many files make millions of objects without cycles, among which the default
    threshold of 700 objects searches for garbage again and again.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 20, 20)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Collect garbage after a test of the window, so that no worker thread deletes widgets.

    The hook includes the whole test, because its fixtures exist until it has ended. Earlier objects
    are frozen, so that the collection considers only objects of the test.
    """
    if "qapp" not in getattr(item, "fixturenames", ()):
        return (yield)
    from tests.support.leaked_resources import find_leaks

    gc.disable()
    gc.freeze()
    try:
        ended = yield
        if leaks := find_leaks():
            _fail(item, "left behind: " + ", ".join(leaks))
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
    """Folder of the reference surveys, which is beside the checkout and not part of it."""
    folder = Path(__file__).resolve().parents[2] / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("the reference surveys are not beside this checkout")
    return folder


@pytest.fixture(scope="session")
def port(tmp_path_factory: pytest.TempPathFactory) -> SimulatedSurvey:
    """The simulated built-in survey with the labels of all points."""
    return make_once(tmp_path_factory, "port", lambda _folder: port_survey())


@pytest.fixture(scope="session")
def whole_demo(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The built-in survey without targets; tests must not change it on disk."""
    return make_once(tmp_path_factory, "whole", make_demo)


@pytest.fixture(scope="session")
def demo_project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The built-in survey with a sixth of the points, for tests that do not need all."""
    return make_once(
        tmp_path_factory, "made", lambda folder: make_demo(folder, points_per_second=DEMO_PULSES)
    )


@pytest.fixture(scope="session")
def denser_project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The built-in survey with a third of the points, for comparisons of lines."""
    return make_once(
        tmp_path_factory,
        "denser",
        lambda folder: make_demo(folder, points_per_second=2 * DEMO_PULSES),
    )


@pytest.fixture(scope="session")
def printed_demo(
    demo_project: Project, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Path, int, str, str]:
    """Folder, exit code and output of `lispac demo`; tests must not change it on disk.

    The survey has half of its points.
    """

    def run_demo(folder: Path) -> tuple[Path, int, str, str]:
        shutil.copytree(demo_project.folder, folder)
        old_file = b"left by an earlier run, which the next one replaces"
        (folder / "raw" / "L1_000.laz").write_bytes(old_file)
        with (
            pytest.MonkeyPatch.context() as patch,
            redirect_stdout(StringIO()) as out,
            redirect_stderr(StringIO()) as err,
        ):
            make = partial(make_demo, points_per_second=3 * DEMO_PULSES)
            patch.setattr("lispac.workflow.planning.demo.make_demo", make)
            code = main(["demo", "--output", str(folder), "--no-window"])
        return folder, code, out.getvalue(), err.getvalue()

    return make_once(tmp_path_factory, "printed", run_demo)


@pytest.fixture(scope="session")
def calibrated(
    demo_project: Project, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Project, Survey]:
    """The demo project, calibrated and validated; tests must not change it on disk."""

    def calibrate(folder: Path) -> Project:
        shutil.copytree(demo_project.folder, folder)
        return calibrate_demo(open_project(folder))[0]

    project = make_once(tmp_path_factory, "calibrated", calibrate)
    return project, load_survey(project)


@pytest.fixture(scope="session")
def denser_calibrated(
    printed_demo: tuple[Path, int, str, str], tmp_path_factory: pytest.TempPathFactory
) -> tuple[Project, Survey]:
    """The built-in survey with half of the points, as `calibrated`."""

    def take(folder: Path) -> Project:
        shutil.copytree(printed_demo[0], folder, ignore=shutil.ignore_patterns("report.*"))
        return open_project(folder)

    project = make_once(tmp_path_factory, "denser-calibrated", take)
    return project, load_survey(project)


@pytest.fixture(scope="session")
def manual_pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of the built manual; any warning of the builder is an error."""

    def build(folder: Path) -> Path:
        folder.mkdir()
        build_manual(resource_path("manual"), folder, strict=True)
        return folder

    return make_once(tmp_path_factory, "manual", build)


@pytest.fixture
def copy(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """A copy of the calibrated project that a test may change."""
    return open_project(Path(shutil.copytree(calibrated[0].folder, tmp_path / "copy")))


@pytest.fixture
def denser_copy(denser_calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """A copy of the calibrated project with half of the points that a test may change."""
    return open_project(Path(shutil.copytree(denser_calibrated[0].folder, tmp_path / "copy")))


@pytest.fixture
def shown(qtbot):
    """Function that shows a viewport with a given budget; all are closed at the end."""
    from PySide6.QtCore import QCoreApplication, QEvent
    from PySide6.QtGui import QGuiApplication

    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    from lispac.gui.viewport.vtk_viewport import VtkViewport
    from tests.gui.support import finish_layouts

    views = []

    def show(budget=None):
        view = VtkViewport(budget=budget)
        view.show_line_legend(False)  # has the colours that tests search for in pictures
        views.append(view)
        view.widget.resize(800, 600)
        view.widget.show()
        qtbot.waitExposed(view.widget)
        finish_layouts()
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


@pytest.fixture
def cloudcompare() -> str:
    """Path of CloudCompare; the test is skipped where it is not installed."""
    program = shutil.which("CloudCompare") or shutil.which("cloudcompare.CloudCompare")
    if program is None:
        pytest.skip("CloudCompare is not installed")
    return program
