"""Tests of the files with boresight and lever arm for other programs.

The files are read with ``json`` only, and their numbers are applied by formulas written here from
the source code of each program.
"""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.errors import InputError
from lispac.io.trajectory.sbet import read_sbet
from lispac.message_texts import message_text
from lispac.project import Project
from lispac.survey.conventions.conversion import ConventionSetup
from lispac.survey.conventions.matrix_input import matrix_of_text
from lispac.survey.conventions.mounting_replacement import MountingReplacement, replace_mounting
from lispac.survey.conventions.systems import SYSTEMS, convention_of_key
from lispac.survey.georeferencing import Mounting, georeference, place_points
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.output.installation import (
    format_of_path,
    installation_formats,
    write_installation,
)
from tests.cli.test_cli_angles import run, run_json
from tests.support.command_errors import refused_with
from tests.support.error_codes import has_code
from tests.support.trajectory_files import vessel, write_records
from tests.survey.test_conventions import FORMULAS, LEVER_ARM, down_frame, north_west_up, survey

MOUNTING = Mounting(LEVER_ARM, np.radians([12.0, 7.0, -15.0]))
COVARIANCE = np.diag(np.radians([0.002, 0.003, 0.004])) ** 2


def replacement(
    key: str,
    mounting: Mounting = MOUNTING,
    *,
    has_lever_arm: bool = True,
    setup: ConventionSetup | None = None,
) -> MountingReplacement:
    return replace_mounting(
        setup or ConventionSetup(convention_of_key(key)), mounting, COVARIANCE, None,
        applied=False, has_lever_arm=has_lever_arm,
    )  # fmt: skip


def written(path: Path, new: MountingReplacement, trajectory: Path | None = None) -> list[str]:
    """Write a file by its ending; return the codes of the notes."""
    form = format_of_path(
        path, new.in_system.setup.convention, with_trajectory=trajectory is not None
    )
    return [each.code for each in write_installation(path, new, form, trajectory=trajectory)]


def transform_of(option: str) -> np.ndarray:
    """A matrix as PDAL parses it: 16 numbers between blanks, row by row."""
    return np.array([float(word) for word in option.split()]).reshape(4, 4)


def placed_in_ned(points_body: np.ndarray, attitude: np.ndarray) -> np.ndarray:
    """Points of a body frame forward, starboard, down, relative to the POS, north, west, up."""
    return np.array(
        [
            north_west_up(down_frame(roll, -pitch, heading) @ x)
            for x, (roll, pitch, heading) in zip(points_body, attitude, strict=True)
        ]
    )


# -- PDAL ------------------------------------------------------------------------------------------


def test_pdal_converts_scanner_points_to_the_body_frame(tmp_path: Path) -> None:
    points, poses = survey()
    codes = written(tmp_path / "a.json", replacement("pdal"))
    (stage,) = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert stage["type"] == "filters.transformation"
    matrix = transform_of(stage["matrix"])
    body = points @ matrix[:3, :3].T + matrix[:3, 3]
    np.testing.assert_array_equal(matrix[3], [0, 0, 0, 1])
    ours = place_points(points, poses, MOUNTING) - poses.position
    assert np.abs(placed_in_ned(body, poses.attitude) - ours).max() < 1e-9
    assert codes == ["convention.pdal_transformation", "convention.file_not_tried"]
    assert set(stage) == {"type", "matrix", "user_data"}
    assert len(stage["user_data"]["remarks"]) == 2


def test_pdal_georeferences_as_the_program_does(tmp_path: Path) -> None:
    """With an SBET with wander angle, and a latency."""
    records = vessel(640, rate=64.0, wander=0.02)
    sbet = write_records(tmp_path / "pos.sbet", records)
    mounting = replace(MOUNTING, latency=0.25)
    codes = written(tmp_path / "a.json", replacement("pdal", mounting), sbet)
    (stage,) = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert stage["type"] == "filters.georeference"
    assert Path(stage["trajectory_file"]) == sbet.resolve()
    assert "convention.offsets" not in codes

    rng = np.random.default_rng(5)
    chosen = rng.integers(20, 600, 200)
    points, time = rng.uniform(-100, 100, (200, 3)), records[chosen, 0] - 0.25
    states = records[np.searchsorted(records[:, 0], time + stage["time_offset"])]
    matrix = transform_of(stage["scan2imu"])
    theirs = []
    for x, state in zip(points, states, strict=True):
        latitude, longitude, height, roll, pitch = state[[1, 2, 3, 7, 8]]
        ned = down_frame(roll, pitch, state[9] - state[10]) @ (matrix[:3, :3] @ x + matrix[:3, 3])
        theirs.append(earth_centred(latitude, longitude, height, ned))
    raw = read_sbet(sbet)
    frame = raw.mean_frame()
    local = georeference(points, time, LocalTrajectory.of(raw, frame, 2.0), mounting)
    geodetic = np.column_stack(frame.to_geodetic(local))
    ours = [earth_centred(*each, np.zeros(3)) for each in geodetic]
    assert np.abs(np.array(theirs) - np.array(ours)).max() < 2e-8  # the radius has 1e-9 m


def earth_centred(latitude, longitude, height, ned) -> np.ndarray:
    """WGS 84, earth-centred, of a point north, east and down of a place."""
    a, e2 = 6378137.0, 0.0066943799901413165
    sin_lat, cos_lat, sin_lon, cos_lon = (
        f(v) for v in (latitude, longitude) for f in (np.sin, np.cos)
    )
    radius = a / np.sqrt(1 - e2 * sin_lat**2)
    place = np.array([(radius + height) * cos_lat * cos_lon, (radius + height) * cos_lat * sin_lon,
                      (radius * (1 - e2) + height) * sin_lat])  # fmt: skip
    north = np.array([-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat])
    east = np.array([-sin_lon, cos_lon, 0.0])
    down = -np.array([cos_lat * cos_lon, cos_lat * sin_lon, sin_lat])
    return place + ned[0] * north + ned[1] * east + ned[2] * down


def test_pdal_gets_no_trajectory_that_it_would_read_in_another_way(tmp_path: Path) -> None:
    records = vessel(2000)
    new = replacement("pdal")
    for change, code in (
        (lambda r: np.degrees(r[:, [1, 2, 7, 8, 9, 10]]), "convention.sbet_signs"),
        (lambda r: r[:, [1, 2, 7, 8, 9, 10]] * [1, 1, 1, -1, 1, 1], "convention.sbet_signs"),
    ):
        other = records.copy()
        other[:, [1, 2, 7, 8, 9, 10]] = change(other)
        path = write_records(tmp_path / "b.sbet", other)
        with pytest.raises(InputError, check=has_code(code)):
            written(tmp_path / "a.json", new, path)
    (tmp_path / "c.sbet").write_text("no trajectory\n" * 100, encoding="utf-8")
    with pytest.raises(InputError, check=has_code("convention.not_sbet")):
        written(tmp_path / "a.json", new, tmp_path / "c.sbet")
    with pytest.raises(InputError, check=has_code("file.not_found")):
        written(tmp_path / "a.json", new, tmp_path / "gone.sbet")
    assert not (tmp_path / "a.json").exists()


# -- Kluster ---------------------------------------------------------------------------------------

KLUSTER_NEEDS = {
    *(f"{s}_{v}" for s in ("tx", "rx") for v in (*"xyzrph", "opening_angle")),
    "waterline", "latency", "sonar_type", "source",
}  # fmt: skip
"""Entries of a system with one head without which the vessel window of Kluster does not open."""


def test_kluster_reads_the_vessel_and_places_the_points(tmp_path: Path) -> None:
    points, poses = survey()
    codes = written(tmp_path / "boat.kfc", replacement("kluster"))
    vessels = json.loads((tmp_path / "boat.kfc").read_text(encoding="utf-8"))
    ((serial, entries),) = vessels.items()
    assert not serial.isdigit(), "serial numbers of sonars"
    assert set(entries) >= KLUSTER_NEEDS
    times = {time for each in entries.values() for time in each}
    assert len(times) == 1, "all entries have the same times"
    (time,) = times
    assert 0 < int(time) < 10**9, "before every survey"
    for sensor in ("tx", "rx"):
        lever_arm, angles = (
            np.array([float(entries[f"{sensor}_{letter}"][time]) for letter in letters])
            for letters in ("xyz", "rph")
        )
        # `build_rot_mat`, from a scanner forward, starboard, down to the vessel, like `down_frame`
        body = (points * [1, -1, -1]) @ down_frame(*np.radians(angles)).T + lever_arm
        ours = place_points(points, poses, MOUNTING) - poses.position
        assert np.abs(placed_in_ned(body, poses.attitude) - ours).max() < 1e-9
    assert [float(entries[f"imu_{letter}"][time]) for letter in "xyzrph"] == [0.0] * 6
    sigmas = [entries[f"{name}_patch_error"][time] for name in ("roll", "pitch", "heading")]
    assert all(0.001 < each < 0.006 for each in sigmas)
    assert codes == ["convention.kluster_vessel", "convention.file_not_tried"]


# -- text ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("key", [each.key for each in SYSTEMS])
def test_the_text_for_any_program_can_be_read_back(tmp_path: Path, key: str) -> None:
    new = replacement(key)
    written(tmp_path / "a.txt", new)
    text = (tmp_path / "a.txt").read_text(encoding="utf-8")
    block = re.findall(r"^(?: +-?\d\.\d{12}){4}$", text, re.MULTILINE)
    rotation, lever_arm = matrix_of_text("\n".join(block[-4:]), "a.txt")
    np.testing.assert_allclose(rotation, new.in_system.transform[:3, :3], rtol=0, atol=1e-11)
    np.testing.assert_allclose(lever_arm, new.in_system.lever_arm, rtol=0, atol=1e-11)
    if new.in_system.angles is not None and key in FORMULAS and key != "phoenix":
        angles = [shown_angle(text, name) for name in new.in_system.setup.convention.names]
        points, poses = survey(50)
        theirs = FORMULAS[key](points, np.radians(angles), new.in_system.lever_arm, poses.attitude)
        ours = place_points(points, poses, MOUNTING) - poses.position
        assert np.abs(theirs - ours).max() < 0.001  # four decimals of a degree
    unverified = convention_of_key(key).status != "verified"
    checked = " ".join(text.split())
    assert (message_text(lispac.Message("convention.check_first", "note")) in checked) is unverified


def shown_angle(text: str, name: str) -> float:
    (row,) = (line for line in text.splitlines() if line.startswith(f"  {name.capitalize()}  "))
    return float(row[len(name) + 2 :].split()[0])


# -- refusals and files ----------------------------------------------------------------------------


def test_files_for_other_programs_need_complete_and_documented_values(tmp_path: Path) -> None:
    for key, name in (("pdal", "a.json"), ("kluster", "a.kfc")):
        with pytest.raises(InputError, check=has_code("convention.file_needs_lever_arm")):
            written(tmp_path / name, replacement(key, has_lever_arm=False))
        kept = "turned" if key == "pdal" else "kept"
        setup = ConventionSetup(convention_of_key(key), scanner=kept)
        with pytest.raises(InputError, check=has_code("convention.file_as_documented")):
            written(tmp_path / name, replacement(key, setup=setup))
    assert not list(tmp_path.iterdir())
    written(tmp_path / "a.txt", replacement("kluster", has_lever_arm=False))
    mounting = replace(MOUNTING, range_offset=0.02)
    assert "convention.offsets" in written(tmp_path / "a.kfc", replacement("kluster", mounting))


def test_the_ending_selects_the_file(tmp_path: Path) -> None:
    with pytest.raises(
        InputError, check=has_code("convention.file_ending", endings=(".kfc", ".txt"))
    ):
        written(tmp_path / "a.json", replacement("kluster"))
    with pytest.raises(InputError, check=has_code("convention.file_ending", endings=(".txt",))):
        written(tmp_path / "a.hvf", replacement("caris"))
    with pytest.raises(InputError, check=has_code("convention.no_trajectory_in_file")):
        written(tmp_path / "a.kfc", replacement("kluster"), tmp_path / "pos.sbet")
    kinds = [
        (each.ending, each.with_trajectory)
        for each in installation_formats(convention_of_key("pdal"), with_trajectory=True)
    ]
    assert kinds == [(".json", False), (".json", True), (".txt", False)]


def test_an_existing_file_is_replaced_as_a_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.json"
    path.write_text("old", encoding="utf-8")

    def fail(*_arguments: object, **_words: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_text", fail)
        with pytest.raises(InputError, check=has_code("file.disk_full")):
            written(path, replacement("pdal"))
    assert path.read_text(encoding="utf-8") == "old"
    written(path, replacement("pdal"))
    assert json.loads(path.read_text(encoding="utf-8"))
    assert [each.name for each in tmp_path.iterdir()] == ["a.json"]
    with pytest.raises(InputError, check=has_code("file.not_writable")):
        written(path / "b.json", replacement("pdal"))


# -- command line and script -----------------------------------------------------------------------


def test_the_command_writes_the_file(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    words = (12.0, 7.0, -15.0, "--lever-arm", *LEVER_ARM, "--to", "pdal")
    path = tmp_path / "a.json"
    content = run_json(capsys, *words, "--output", path)
    assert content["file"] == str(path)
    matrix = transform_of(json.loads(path.read_text(encoding="utf-8"))[0]["matrix"])
    np.testing.assert_allclose(matrix, content["to"]["transform"], rtol=0, atol=1e-15)
    assert run_json(capsys, *words)["file"] is None
    code, _, err = run(capsys, *words, "--output", path)
    assert (code, err.count("\n")) == (0, 2)
    sbet = write_records(tmp_path / "pos.sbet", vessel(2000))
    run_json(capsys, *words, "--output", path, "--trajectory", sbet)
    assert json.loads(path.read_text(encoding="utf-8"))[0]["type"] == "filters.georeference"
    refused_with("convention.file_needs_lever_arm", "angles", 1, 2, 3, "--to", "kluster",
                 "--output", tmp_path / "a.kfc")  # fmt: skip
    assert run(capsys, "--output", path)[0] == 2
    assert run(capsys, *words, "--trajectory", sbet)[0] == 2


def test_a_script_writes_the_file_of_a_project(
    calibrated: tuple[Project, object], tmp_path: Path
) -> None:
    project, _ = calibrated
    quay = lispac.OpenProject(project)
    notes = quay.save_installation("kluster", tmp_path / "boat.kfc")
    assert len(notes) >= 2
    (entries,) = json.loads((tmp_path / "boat.kfc").read_text(encoding="utf-8")).values()
    (pitch,) = entries["tx_p"].values()
    assert pitch == pytest.approx(-quay.boresight_deg[1], abs=0.01)
    quay.save_installation("pdal", tmp_path / "p.json", trajectory=project.trajectory)
    (stage,) = json.loads((tmp_path / "p.json").read_text(encoding="utf-8"))
    assert stage["time_offset"] == float(project.mounting("estimated").latency)
    own = tmp_path / "own.json"
    own.write_text("{}", encoding="utf-8")
    changed = lispac.OpenProject(replace(project, accuracy=own))
    with pytest.raises(InputError, check=has_code("export.own_file")):
        changed.save_installation("pdal", own)
