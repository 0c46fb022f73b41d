"""Tests of File > Settings: each setting is applied and stored."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance import theme
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.preferences.dialogs import SettingsDialog
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.preferences.sensor_editor import NEW_POS, NEW_SCANNER, SensorEditor
from lispac.gui.viewport.decimation import Budget
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.io.config.sensor_file import PosSpecification, ScannerSpecification
from lispac.project import Settings
from lispac.workflow.planning.sensors import read_library, store_sensor
from lispac.workflow.project.projects import new_project
from tests.gui.support import Driver, Key, Left, click_in_box, in_front, press, use_next_dialog
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown

OTHER_PREFERENCES = Preferences("fr", 5, 3_500_000, "applanix", "zf-9012", "apogee:ppk",
                     theme="dark", scale="turbo")  # fmt: skip
OWN_SCANNER = ScannerSpecification("Profiler 16", 0.004, 0.0125, 0.3, "Data sheet of 2026-03")


@pytest.fixture
def page(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[SettingsDialog]:
    """Settings dialogue of a new user."""
    theme.apply_theme(qapp)
    made = SettingsDialog(Preferences(), tmp_path / "sensors")
    made.show()
    yield made
    made.close()
    made.deleteLater()


def choose_preferences(
    driver: Driver, monkeypatch: pytest.MonkeyPatch, chosen: Preferences
) -> list:
    """Answer the settings dialogue with ``chosen``; return the list of values it is opened with."""
    opened_with: list[Preferences] = []

    def preferences(present: Preferences, _settings: AppSettings) -> Preferences:
        opened_with.append(present)
        return chosen

    monkeypatch.setattr(driver.dialogs, "preferences", preferences)
    return opened_with


def test_settings_are_applied_at_once_and_stored(
    driver: Driver, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
) -> None:
    driver.window.settings.language = "en"
    assert isinstance(driver.viewport, RecordingViewport)
    opened_with = choose_preferences(driver, monkeypatch, OTHER_PREFERENCES)
    with qtbot.waitSignal(driver.window.renewal_requested):
        press(driver, Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    assert opened_with == [Preferences(language="en")]
    assert driver.viewport.point_size == 5
    assert driver.viewport.point_budget == 3_500_000
    assert driver.window.report.options().convention == "applanix"
    again = AppSettings(Path(driver.window.settings.folder) / "settings.ini")
    assert Preferences.of(again) == OTHER_PREFERENCES
    assert again.language == "fr"

    choose_preferences(driver, monkeypatch, Preferences(language="fr"))
    driver.window.actions_["settings"].trigger()
    assert driver.viewport.point_size == Preferences().point_size
    assert driver.viewport.point_budget == Budget().resting
    assert driver.window.report.options().convention == ""


def test_cancelled_settings_change_nothing(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> None:
    before = Preferences.of(driver.window.settings)
    monkeypatch.setattr(driver.dialogs, "preferences", lambda *_: None)
    driver.window.actions_["settings"].trigger()
    assert Preferences.of(driver.window.settings) == before


def test_the_default_language_is_that_of_the_system(tmp_path: Path) -> None:
    settings = AppSettings(tmp_path / "settings.ini")
    OTHER_PREFERENCES.save(settings)
    assert settings.language == "fr"
    Preferences().save(settings)
    system = QLocale.system().name().partition("_")[0]
    assert settings.language == ("fr" if system == "fr" else "en")


@LONG
def test_the_view_draws_as_many_points_as_the_budget(real: Driver) -> None:
    import numpy as np

    real.window.resize(1200, 900)
    viewport = real.viewport
    points = np.random.default_rng(1).uniform(-10, 10, (400_000, 3))
    viewport.show_clouds({"L1": points}, {"L1": (200, 0, 0)})
    viewport.fit()

    def drawn(budget: int) -> int:
        viewport.set_point_budget(budget)
        viewport.picture()
        return sum(len(each) for each in viewport._layer.detail.values())

    assert drawn(100_000) == pytest.approx(100_000, abs=2)
    assert drawn(300_000) > 150_000


def test_the_dialogue_returns_its_values_and_restores_the_defaults(
    page: SettingsDialog, qtbot: QtBot
) -> None:
    assert page.preferences == Preferences()
    page.show_preferences(OTHER_PREFERENCES)
    assert page.preferences == OTHER_PREFERENCES
    qtbot.mouseClick(page.restore, Left)
    assert page.preferences == Preferences()


def test_a_broken_settings_file_gives_the_defaults(tmp_path: Path) -> None:
    (tmp_path / "settings.ini").write_text("[General]\npoint_budget=lots\npoint_size=99\n")
    settings = AppSettings(tmp_path / "settings.ini")
    assert (settings.point_budget, settings.point_size) == (Budget().resting, 2)


# -- sensors -----------------------------------------------------------------------------------


def use_editor(monkeypatch: pytest.MonkeyPatch, bot: QtBot, **texts: str) -> list[SensorEditor]:
    """Type into the editor that opens, and press Keep."""
    opened: list[SensorEditor] = []

    def typed(editor: SensorEditor) -> int:
        opened.append(editor)
        editor.show()
        for name, text in texts.items():
            field = editor.findChild(object, name)
            field.setFocus()
            field.selectAll()
            bot.keyClicks(field, text)
        bot.mouseClick(editor.keep, Left)
        return editor.result()

    monkeypatch.setattr(SensorEditor, "exec", typed)
    return opened


def test_own_sensors_are_added_copied_edited_and_removed(
    page: SettingsDialog, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder, sensors = tmp_path / "sensors", page.library
    page.tabs.setCurrentIndex(1)
    count = sensors.table.rowCount()
    use_editor(
        monkeypatch, qtbot, sensor_title="Profiler 16", sensor_range="4", sensor_angle="0.0125",
        sensor_beam="0.3", sensor_source=OWN_SCANNER.source,
    )  # fmt: skip
    qtbot.mouseClick(sensors.add_scanner, Left)
    assert read_library(folder).scanner("profiler-16") == OWN_SCANNER
    assert sensors.current is not None
    assert sensors.current.figures == OWN_SCANNER
    assert "Profiler 16" in [page.choice.scanner.itemText(k) for k in range(count)]

    use_editor(monkeypatch, qtbot, sensor_range="6")
    qtbot.mouseClick(sensors.edit, Left)
    assert read_library(folder).scanner("profiler-16").range_sigma == 0.006

    sensors.select("apogee")
    assert not sensors.edit.isEnabled()
    assert not sensors.remove.isEnabled()
    use_editor(monkeypatch, qtbot)
    qtbot.mouseClick(sensors.copy, Left)
    theirs, ours = (
        next(s.figures for s in read_library(folder).pos if s.name == name)
        for name in ("apogee", "sbg-systems-apogee-user-defined")
    )
    assert isinstance(ours, PosSpecification)
    assert ours.states == theirs.states
    assert sensors.table.rowCount() == count + 2

    sensors.select("profiler-16")
    use_next_dialog(partial(click_in_box, text="Cancel"))
    qtbot.mouseClick(sensors.remove, Left)
    assert read_library(folder).scanner("profiler-16").range_sigma == 0.006
    use_next_dialog(partial(click_in_box, text="Remove"))
    qtbot.mouseClick(sensors.remove, Left)
    assert [s.name for s in read_library(folder).scanners if s.is_user_defined] == []
    assert sensors.table.rowCount() == count + 1
    qtbot.waitUntil(lambda: in_front(page) and sensors.table.hasFocus())
    assert sensors.current is not None
    # Return chooses the answer that loses nothing
    sensors.select("sbg-systems-apogee-user-defined")
    use_next_dialog(lambda box: qtbot.keyClick(box, Key.Key_Return))
    qtbot.mouseClick(sensors.remove, Left)
    assert sensors.table.rowCount() == count + 1


def test_invalid_sensors_are_reported_while_typing(qtbot: QtBot, tmp_path: Path) -> None:
    store_sensor(tmp_path, OWN_SCANNER)
    editor = SensorEditor(tmp_path, NEW_SCANNER, "")
    qtbot.addWidget(editor)
    editor.show()
    qtbot.waitUntil(lambda: in_front(editor))
    assert editor.message_label.text() == ""
    qtbot.keyClick(editor.title, Key.Key_Tab)
    assert "needs a title" in editor.message_label.text()
    qtbot.keyClicks(editor.title, "Profiler 16")
    assert editor.message_label.text() == ""
    qtbot.mouseClick(editor.keep, Left)
    assert "source of the specifications" in editor.message_label.text()
    assert editor.parts[0].origin.source.hasFocus()
    assert not editor.keep.isEnabled()
    qtbot.keyClicks(editor.parts[0].origin.source, "Certificate")
    assert "already" in editor.message_label.text()
    assert not editor.keep.isEnabled()
    qtbot.keyClicks(editor.title, " B")
    assert editor.message_label.text() == ""
    assert editor.keep.isEnabled()

    pos = SensorEditor(tmp_path, NEW_POS, "")
    qtbot.addWidget(pos)
    pos.show()
    qtbot.keyClicks(pos.title, "My INS")
    assert pos.message_label.text() == ""
    qtbot.mouseClick(pos.keep, Left)
    assert "source of the specifications" in pos.message_label.text()
    pos.parts[1].is_specified.setChecked(False)
    assert is_shown("sensor.no_sigmas", pos.message_label.text())


def test_a_broken_file_is_named_above_the_buttons(
    qtbot: QtBot, qapp: QApplication, tmp_path: Path
) -> None:
    path = tmp_path / "scanners" / "mine.toml"
    path.parent.mkdir()
    path.write_text('title = "Mine"\n')
    dialog = SettingsDialog(Preferences(), tmp_path)
    qtbot.addWidget(dialog)
    assert dialog.library.message_label.text() == f"{path}: range_sigma_m is missing. Add it."


def test_a_new_project_starts_with_the_default_sensors_and_names_them(
    dialog: ImportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    settings = AppSettings(tmp_path / "settings.ini")
    settings.default_sensors = ("zf-9012", "apogee:ppk")
    other = ImportDialog(settings)
    qtbot.addWidget(other)
    sensor_settings = other.mounting.settings()
    assert sensor_settings.lidar_beam_sigma == (0.0087, 0.02)
    assert sensor_settings.attitude_sigma_deg == (0.005, 0.005, 0.01)
    assert dialog.mounting.settings() == Settings((0.0, 0.0, 0.0))  # no mounting was typed
    other.work.close()
    settings.keep_sensors(("riegl-vux-1", "hydrins:rtk"))
    assert settings.default_sensors == ("zf-9012", "apogee:ppk"), "the user has chosen them"
    settings.default_sensors = ("", "")
    settings.keep_sensors(("riegl-vux-1", ""))
    assert settings.default_sensors == ("riegl-vux-1", "")


@LONG
def test_chosen_sensors_fill_editable_fields(
    filled: ImportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    page = filled.mounting
    assert filled.request().settings.lidar_beam_sigma is None
    page.sensors.choose("riegl-vux-1", "hydrins:rtk")
    assert "not verified" in page.sensors.scanner_origin.text()
    assert page.sensors.pos_origin.text().startswith("Shahraji")
    page.angle_sigma.setValue(0.004)
    filled.folder.setText(str(tmp_path / "made"))
    request = filled.request()
    assert request.settings.lidar_sigma == 0.005
    assert request.settings.lidar_beam_sigma == (0.005, 0.004)
    project, _survey = new_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings,
        accuracy=request.accuracy, trajectory_reading=request.trajectory_reading,
        accuracy_reading=request.accuracy_reading, identity=request.identity,
    )  # fmt: skip
    assert project.identity.scanner == "RIEGL VUX-1UAV"
    assert project.identity.pos == "Exail (iXblue) Hydrins"


def test_the_cache_is_in_the_chosen_folder(
    driver: Driver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    chosen = Preferences(language=driver.window.settings.chosen_language, cache=tmp_path / "fast")
    choose_preferences(driver, monkeypatch, chosen)
    driver.window.actions_["settings"].trigger()
    assert driver.window.settings.cache_folder == tmp_path / "fast"
    assert Preferences.of(driver.window.settings) == chosen

    (tmp_path / "file").write_text("")
    choose_preferences(driver, monkeypatch, Preferences(point_size=7, cache=tmp_path / "file"))
    driver.window.actions_["settings"].trigger()
    assert driver.dialogs.errors[-1].code == "cache.folder_not_writable"
    assert driver.window.settings.cache_folder == tmp_path / "fast"
    assert driver.window.settings.point_size == 7


def test_the_cache_is_shown_and_emptied_after_confirmation(
    page: SettingsDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    place = tmp_path / "disk" / "lispac"
    (place / "numba").mkdir(parents=True)
    (place / "numba" / "kernel").write_bytes(bytes(2_500_000))
    (tmp_path / "file").write_text("")
    page.cache.choose_folder(tmp_path / "file")
    assert is_shown("cache.folder_not_writable", page.cache.message_label.text())
    page.cache.choose_folder(tmp_path / "disk")
    assert page.preferences.cache == tmp_path / "disk"
    assert page.cache.place.text() == str(place)
    assert page.cache.size.text() == "2.5 MB"
    assert page.cache.message_label.text() == ""

    for button, is_kept in (("Cancel", True), ("Clear cache", False)):
        use_next_dialog(partial(click_in_box, text=button))
        qtbot.mouseClick(page.cache.empty, Left)
        assert (place / "numba").exists() is is_kept
    assert page.cache.size.text() == "The cache is empty"
    assert not page.cache.empty.isEnabled()
    qtbot.mouseClick(page.cache.usual, Left)
    assert page.preferences.cache is None
