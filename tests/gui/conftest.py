"""Fixtures: the demo survey in several states, and windows that show it."""

import shutil
import threading
from collections import defaultdict, deque
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication, QDialog
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.features.design.window import DesignWindow
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.pick_targets import target_actions
from lispac.gui.features.report.dialogs import ReportDialogs
from lispac.gui.project import controller
from lispac.gui.project.recovery_copies import LOCK_FILE_NAME
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.window.session import Session
from lispac.io.project.project_file import UNSAVED_NAME
from lispac.progress import Progress, no_progress
from lispac.project import Project
from lispac.simulation.thesis_site import SITES
from lispac.simulation.visibility_study import VisibilityStudy, study_visibility
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.calibration.sighting_assessment import (
    AssessedQuality,
    SightingKey,
    assess_sightings,
)
from lispac.workflow.checking.validation import validate
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.gui.by_hand import Hands
from tests.gui.design_support import opened_by_keys
from tests.gui.import_support import drop, raw, rest
from tests.gui.shared_surveys import load_once
from tests.gui.support import WAIT_MS, Demo, Driver, PatientBot, ScriptedDialogs
from tests.support.sharing import make_once

PICKED_NAMES = ("T1", "T2", "V1")
WINDOW_FILES = shutil.ignore_patterns(UNSAVED_NAME, LOCK_FILE_NAME)
"""Files that a window of another test process may keep in the shared demo folder."""

QUALITY_FILES = {"test_gui_quality.py"}
ASSESSED: defaultdict[SightingKey, deque[AssessedQuality]] = defaultdict(lambda: deque(maxlen=6))
"""Last assessed qualities of each sighting in this process."""


def _picked_demo(source: Project, factory: pytest.TempPathFactory, name: str) -> Demo:
    """The survey of a project as made, and with some planes picked.

    Each process has its own folder, which a window locks while it writes a recovery copy.
    """
    folder = factory.mktemp("demo") / source.folder.name
    shutil.copytree(source.folder, folder, ignore=WINDOW_FILES)
    project = replace(source, folder=folder)
    survey = load_once(project)

    def pick_some(_folder: Path) -> Project:
        picked = project
        for target in PICKED_NAMES:
            role, seed = demo_seeds()[target]
            picked = pick_target(picked, survey, seed, name=target, role=role)
        return picked

    picked = make_once(factory, name, pick_some)
    return Demo(project, replace(picked, folder=folder), survey)


@pytest.fixture(scope="session")
def demo(demo_project: Project, tmp_path_factory: pytest.TempPathFactory) -> Demo:
    """The demo survey as made, and with some planes picked."""
    return _picked_demo(demo_project, tmp_path_factory, "picked")


@pytest.fixture(scope="session")
def denser_demo(denser_project: Project, tmp_path_factory: pytest.TempPathFactory) -> Demo:
    """As `demo` with twice as many points, whose residuals pass the test of the adjustment."""
    return _picked_demo(denser_project, tmp_path_factory, "picked-denser")


@pytest.fixture(scope="session")
def estimated(demo: Demo, tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The picked demo survey with its estimated boresight and all cross-checks."""
    made = make_once(
        tmp_path_factory, "estimated", lambda _folder: estimate(demo.picked, demo.survey)
    )
    return replace(made, folder=demo.project.folder)


@pytest.fixture(scope="session")
def validated(demo: Demo, estimated: Project, tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The estimated demo survey with one validation plane compared."""
    made = make_once(
        tmp_path_factory, "validated", lambda _folder: validate(estimated, demo.survey)
    )
    return replace(made, folder=demo.project.folder)


@pytest.fixture(scope="session")
def visibility_studies(tmp_path_factory: pytest.TempPathFactory) -> list[VisibilityStudy]:
    """The study of visibility for each of its sites."""
    return make_once(
        tmp_path_factory,
        "visibility",
        lambda _folder: [study_visibility(site) for site in SITES.values()],
    )


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> PatientBot:
    """Replace the bot of pytest-qt."""
    return PatientBot(request)


@pytest.fixture(autouse=True)
def _no_file_is_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do not start other programs with real dialogues."""
    monkeypatch.setattr(ReportDialogs, "open_file", lambda _self, _path: True)


@pytest.fixture(autouse=True)
def _share_qualities(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Reuse qualities of sightings that another window assessed from the same arrays.

    Most windows show the same few projects, and their assessment is a quarter of the time of a
    test. The tests of the qualities themselves assess all sightings.
    """
    if request.path.name not in QUALITY_FILES:
        monkeypatch.setattr(target_actions, "assess_sightings", _assess_once)


@pytest.fixture(autouse=True)
def _share_surveys(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reuse a survey that was read from the same files, as most windows open copies of the demo."""
    monkeypatch.setattr(controller, "load_survey", load_once)


@pytest.fixture
def reads_files(_share_surveys: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Read the files whenever a project is opened, for tests of what happens meanwhile."""
    monkeypatch.setattr(controller, "load_survey", load_survey)


def _assess_once(
    project: Project,
    survey: Survey,
    *,
    known: Mapping[SightingKey, AssessedQuality] | None = None,
    progress: Progress = no_progress,
) -> dict[SightingKey, AssessedQuality]:
    valid = {
        (target.name, sighting.line): each
        for target in project.targets
        for sighting in target.sightings
        for each in ASSESSED[target.name, sighting.line]
        if each.is_current(project, target, sighting)
    }
    found = assess_sightings(project, survey, known={**(known or {}), **valid}, progress=progress)
    for key, each in found.items():
        if each is not valid.get(key):
            ASSESSED[key].append(each)
    return found


@pytest.fixture
def demo_copy(demo: Demo, tmp_path: Path) -> Path:
    """A folder of the demo project that the test may change."""
    return Path(shutil.copytree(demo.project.folder, tmp_path / "harbour", ignore=WINDOW_FILES))


@pytest.fixture
def picked_folder(demo: Demo, demo_copy: Path) -> Path:
    """A project folder with picked targets."""
    save_project(replace(demo.picked, folder=demo_copy))
    return demo_copy


@pytest.fixture
def driver(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Driver]:
    """An empty window with a recording viewport."""
    theme.apply_theme(qapp)
    made = Driver(qtbot, RecordingViewport(), tmp_path)
    yield made
    made.leave()


@pytest.fixture
def real(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Driver]:
    """An empty window with a viewport that draws."""
    if qapp.platformName() == "offscreen":
        pytest.skip("OpenGL needs a screen, if only a virtual one")
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    theme.apply_theme(qapp)
    made = Driver(qtbot, VtkViewport(), tmp_path)
    yield made
    made.leave()


@pytest.fixture
def hands(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Hands]:
    """The program with an empty window, a viewport that draws and real dialogues."""
    if qapp.platformName() == "offscreen":
        pytest.skip("OpenGL needs a screen, if only a virtual one")
    from lispac.gui.viewport.lazy_viewport import LazyViewport
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    made = Hands(qtbot, lambda: LazyViewport(VtkViewport), tmp_path)
    yield made
    made.leave()


@pytest.fixture
def opened(driver: Driver, demo: Demo) -> Driver:
    """A window with the demo survey and no targets."""
    driver.window.document.open(demo.project, demo.survey)
    driver.rest()
    return driver


@pytest.fixture
def picked(driver: Driver, demo: Demo) -> Driver:
    """A window with the demo survey, two targets and a validation plane."""
    driver.window.document.open(demo.picked, demo.survey)
    driver.rest()
    return driver


@pytest.fixture
def adjusted(driver: Driver, demo: Demo, estimated: Project) -> Driver:
    """A window with the demo survey and its estimated boresight."""
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    return driver


@pytest.fixture
def dialog(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[ImportDialog]:
    """An empty import dialogue; afterwards, check that no window or thread of it remains."""
    theme.apply_theme(qapp)
    made = ImportDialog(AppSettings(tmp_path / "settings.ini"))
    made.show()
    made.activateWindow()
    qtbot.waitUntil(made.isActiveWindow, timeout=WAIT_MS)
    yield made
    made.done(QDialog.DialogCode.Rejected)
    made.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QCoreApplication.processEvents()
    assert [w for w in QApplication.topLevelWidgets() if w.isVisible()] == []
    assert [t.name for t in threading.enumerate() if t.name == "lispac-worker"] == []


@pytest.fixture
def filled(dialog: ImportDialog, qtbot: QtBot, demo: Demo) -> ImportDialog:
    """An import dialogue with the files of the demo survey, dropped and examined."""
    drop(dialog, raw(demo))
    rest(qtbot, dialog)
    return dialog


@pytest.fixture
def design(driver: Driver) -> DesignWindow:
    """The design window, opened with its shortcut."""
    return opened_by_keys(driver)


@pytest.fixture
def session(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Session]:
    """A session with a window in English and in the light theme."""
    settings = AppSettings(tmp_path / "settings.ini")
    settings.language, settings.theme = "en", "light"
    made = Session(qapp, RecordingViewport, settings, ScriptedDialogs())
    qtbot.waitUntil(made.window.isActiveWindow, timeout=WAIT_MS)
    yield made
    made.window.stop_and_hide()
    made.window.deleteLater()
    made.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    set_language("en")
    theme.apply_theme(qapp)
