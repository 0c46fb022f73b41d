"""Tests of the sensor library: its values and sources, user-defined sensors, and their use."""

import tomllib
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QStandardPaths

from lispac.errors import InputError
from lispac.installation_paths import resource_path, user_folder
from lispac.io.config.scanner_file import read_scanner
from lispac.io.config.sensor_file import (
    GNSS_SOLUTIONS,
    PosAccuracy,
    PosSpecification,
    ScannerSpecification,
    read_pos_specification,
)
from lispac.language import in_language
from lispac.message_texts import english_text
from lispac.project import Settings
from lispac.workflow.planning import sensors
from lispac.workflow.project.projects import open_project
from tests.cli.test_cli import new_words, run, run_json
from tests.support.command_errors import command_error

OWN_SCANNER = ScannerSpecification(
    'Maker\'s "new" one\\2', 0.004, 0.0125, 0.3, "Data sheet of 2026-03"
)
OWN_INS = PosSpecification(
    "My INS",
    (PosAccuracy("ppk", (0.01, 0.011, 0.02), (0.004, 0.005, 0.009), "Certificate 12", True),),
)
NOT_VERIFIED = "not verified: check the data sheet"
SOURCED_VALUES = {
    "zf-9012": (0.0087, 0.02, 0.5),
    "ouster-os1-128": (0.015, 0.01, 3.14),
}
"""Metres, degrees, milliradians: the thesis's table 1.1; the OS1 data sheet (0.18 deg)."""


def test_every_supplied_sensor_has_sigmas_and_a_source(tmp_path: Path) -> None:
    found = sensors.read_library(tmp_path)
    assert found.messages == ()
    assert {s.name for s in found.scanners} >= {
        "zf-9012", "riegl-vux-1", "riegl-vux-1ha", "velodyne-hdl-32e", "ouster-os1-128",
        "hesai-pandar-xt32",
    }  # fmt: skip
    assert {s.name.partition("-")[0] for s in found.pos} == {"hydrins", "atlans", "pos", "apogee"}
    for scanner in found.scanners:
        assert not scanner.is_user_defined
        assert len(scanner.figures.source) > 20
    for pos in found.pos:
        for state in pos.figures.states:
            assert len(state.source) > 20
            assert state.name in GNSS_SOLUTIONS
        if {"rtk", "degraded"} <= {state.name for state in pos.figures.states}:
            states = {state.name: state for state in pos.figures.states}
            assert states["degraded"].position_sigma > states["rtk"].position_sigma
            assert states["degraded"].attitude_sigma_deg > states["rtk"].attitude_sigma_deg


def test_notes_on_supplied_sensors_are_translated(tmp_path: Path) -> None:
    found = sensors.read_library(tmp_path)
    for figures in (
        *(scanner.figures for scanner in found.scanners),
        *(state for pos in found.pos for state in pos.figures.states),
    ):
        with in_language("fr"):
            french = sensors.source_text(figures)
        assert figures.source in sensors.SUPPLIED_SOURCES
        assert french != sensors.source_text(figures)


@pytest.mark.parametrize("name", SOURCED_VALUES)
def test_values_equal_those_of_the_source(tmp_path: Path, name: str) -> None:
    found = sensors.read_library(tmp_path).scanner(name)
    assert (found.range_sigma, found.angle_sigma_deg, found.divergence_mrad) == SOURCED_VALUES[name]


def test_unverified_values_are_marked(tmp_path: Path) -> None:
    found = sensors.read_library(tmp_path)
    assert NOT_VERIFIED in sensors.source_text(found.scanner("riegl-vux-1"))
    assert NOT_VERIFIED not in sensors.source_text(found.scanner("zf-9012"))
    hydrins, state = found.find_pos("hydrins")
    assert hydrins.title.endswith("Hydrins")
    # thesis, table 1.2: 0.006 m + 0.5 ppm and 0.01 m + 1 ppm at 10 km
    assert state.position_sigma == pytest.approx((0.006 + 5e-3, 0.006 + 5e-3, 0.01 + 1e-2))
    assert state.attitude_sigma_deg == (0.01, 0.01, 0.01)


def test_the_simulator_has_the_same_scanners(tmp_path: Path) -> None:
    for sensor in sensors.read_library(tmp_path).scanners:
        title, scanner = read_scanner(resource_path("scanners") / f"{sensor.name}.toml")
        assert (title, scanner.range_sigma) == (sensor.figures.title, sensor.figures.range_sigma)


def test_user_defined_sensors_are_saved_and_removed(tmp_path: Path) -> None:
    for figures in (OWN_SCANNER, OWN_INS):
        name = sensors.store_sensor(tmp_path, figures)
        found = sensors.read_library(tmp_path)
        (own,) = [s for s in (*found.scanners, *found.pos) if s.is_user_defined]
        assert (own.name, own.figures) == (name, figures)
        changed = replace(figures, title="Renamed")
        assert sensors.store_sensor(tmp_path, changed, name) == name
        found = sensors.read_library(tmp_path)
        (own,) = [s for s in (*found.scanners, *found.pos) if s.is_user_defined]
        assert own.figures == changed
        sensors.remove_sensor(tmp_path, own)
        assert sensors.read_library(tmp_path) == sensors.read_library(tmp_path / "none")


def test_a_user_file_replaces_a_supplied_one(tmp_path: Path) -> None:
    sensors.write_specification(tmp_path / "scanners" / "zf-9012.toml", OWN_SCANNER)
    found = sensors.read_library(tmp_path)
    assert found.scanner("zf-9012") == OWN_SCANNER
    assert len(found.scanners) == len(sensors.read_library(tmp_path / "none").scanners)


def test_an_invalid_user_file_is_named_and_the_others_are_read(tmp_path: Path) -> None:
    path = tmp_path / "pos" / "mine.toml"
    path.parent.mkdir()
    path.write_text('title = "INS"\n[rtk]\nposition_m = [0.01, 0, 0.02]\n')
    found = sensors.read_library(tmp_path)
    assert found.pos == sensors.read_library(tmp_path / "none").pos
    (message,) = found.messages
    assert english_text(message).startswith(f"{path}: rtk.position_m contains zero")


@pytest.mark.parametrize(
    ("figures", "code"),
    [
        (replace(OWN_SCANNER, title=" "), "sensor.no_title"),
        (replace(OWN_SCANNER, source=""), "sensor.no_source"),
        (replace(OWN_SCANNER, source="a\nb"), "sensor.long_text"),
        (PosSpecification("INS", ()), "sensor.no_sigmas"),
    ],
)
def test_invalid_sensors_are_refused(
    tmp_path: Path, figures: ScannerSpecification | PosSpecification, code: str
) -> None:
    with pytest.raises(InputError) as raised:
        sensors.store_sensor(tmp_path, figures)
    assert raised.value.code == code
    assert list(tmp_path.iterdir()) == []


def test_names_are_unique_and_supplied_sensors_are_kept(tmp_path: Path) -> None:
    sensors.store_sensor(tmp_path, OWN_SCANNER)
    with pytest.raises(InputError) as raised:
        sensors.store_sensor(tmp_path, OWN_SCANNER)
    assert raised.value.code == "sensor.title_taken"
    supplied = next(s for s in sensors.read_library(tmp_path).scanners if not s.is_user_defined)
    with pytest.raises(InputError) as raised:
        sensors.remove_sensor(tmp_path, supplied)
    assert raised.value.code == "sensor.supplied"


def test_user_sensors_are_in_the_data_folder_of_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    place = QStandardPaths.StandardLocation.GenericConfigLocation
    assert user_folder() == Path(QStandardPaths.writableLocation(place)) / "lispac"


# -- command line ------------------------------------------------------------------------------


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "mine"
    monkeypatch.setattr(sensors, "user_folder", lambda: folder)
    return folder / "sensors"


def test_the_list_has_every_sensor_with_its_source(
    capsys: pytest.CaptureFixture[str], own: Path
) -> None:
    sensors.store_sensor(own, OWN_SCANNER)
    listed = run_json(capsys, "sensors")
    assert listed["folder"] == str(own)
    assert listed["scanners"]["maker-s-new-one-2"]["user_defined"]
    assert listed["pos"]["hydrins"]["states"][0]["source"].startswith("Shahraji's thesis")
    code, out, _ = run(capsys, "sensors")
    assert code == 0
    (row,) = (line for line in out.splitlines() if "Z+F PROFILER 9012" in line)
    assert row.split()[1:4] == ["8.7", "0.0200", "0.50"]
    assert f"{OWN_SCANNER.title} (user-defined)" in out
    assert out.count(NOT_VERIFIED) >= 5


def test_a_new_project_has_sigmas_and_names_of_the_library(
    capsys: pytest.CaptureFixture[str], own: Path, tmp_path: Path, demo_project: object
) -> None:
    raw = demo_project.folder / "raw"  # type: ignore[attr-defined]
    words = [w for w in new_words(tmp_path / "quay", raw) if w not in ("--lidar-sigma", 0.0017)]
    run_json(
        capsys, *words, "--scanner", "zf-9012", "--pos", "apogee:ppk", "--position-sigma", 0.1, 0.1,
        0.2,
    )  # fmt: skip
    project = open_project(tmp_path / "quay")
    usual = Settings(project.settings.lever_arm)
    assert project.settings.lidar_beam_sigma == (0.0087, 0.02)
    assert project.settings.lidar_sigma == 0.0087 != usual.lidar_sigma
    assert project.settings.attitude_sigma_deg == (0.005, 0.005, 0.01)
    assert project.settings.position_sigma == (0.1, 0.1, 0.2)  # given values take precedence
    assert project.identity.scanner == "Z+F PROFILER 9012"
    assert project.identity.pos == "SBG Systems Apogee"
    with (resource_path("scanners") / "zf-9012.toml").open("rb") as file:
        assert tomllib.load(file)["range_sigma_m"] == project.settings.lidar_sigma


@pytest.mark.parametrize(
    ("option", "word", "code"),
    [
        ("--scanner", "nikon", "sensor.no_scanner"),
        ("--pos", "apogee", "sensor.no_solution"),
        ("--pos", "sextant", "sensor.no_pos"),
    ],
)
def test_unknown_sensors_are_reported(
    own: Path, tmp_path: Path, option: str, word: str, code: str
) -> None:
    words = [
        w
        for w in new_words(tmp_path / "quay", tmp_path, tmp_path / "L1.las")
        if w not in ("--lidar-sigma", 0.0017)
    ]
    refusal = command_error(*words, option, word)
    assert refusal.code == code
    assert word in str(refusal)
    assert not (tmp_path / "quay").exists()


def test_a_pos_without_sigmas_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('title = "My INS"\n')
    with pytest.raises(InputError) as caught:
        read_pos_specification(path)
    assert caught.value.code == "sensor.no_accuracies"
    assert caught.value.message.params == {"file": str(path), "tables": GNSS_SOLUTIONS}
