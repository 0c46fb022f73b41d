"""Tests of ``lispac angles``: its output, its notes and its refusals."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from lispac.cli.main import main
from lispac.message_texts import message_text
from lispac.messages import note
from lispac.project import Project
from lispac.survey.conventions.systems import SYSTEMS
from lispac.workflow.project.survey import Survey
from tests.support.command_errors import command_error, refused_with


def run(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, str, str]:
    try:
        code = main(["angles", *(str(word) for word in words)])
    except SystemExit as stop:
        code = int(stop.code or 0)
    out, err = capsys.readouterr()
    return code, out, err


def printed_by(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    code, out, err = run(capsys, *words)
    assert code == 0, err
    assert max(map(len, out.splitlines())) <= 120
    return out


def run_json(capsys: pytest.CaptureFixture[str], *words: object) -> Any:
    return json.loads(printed_json(capsys, *words))


def printed_json(capsys: pytest.CaptureFixture[str], *words: object) -> str:
    code, out, err = run(capsys, *words, "--json")
    assert code == 0, err
    return out


def run_refused(capsys: pytest.CaptureFixture[str], *words: object, code: int = 1) -> str:
    got, out, err = run(capsys, *words)
    assert (got, out) == (code, ""), (got, out, err)
    assert err.count("\n") == 1
    return err


def column(text: str, title: str) -> list[float]:
    """The numbers of the column with a title, whose unit is degrees."""
    rows = [re.split(r"\s{2,}", line.strip()) for line in text.splitlines()]
    (head,) = (k for k, row in enumerate(rows) if f"{title} (deg)" in row)
    at = rows[head].index(f"{title} (deg)")
    return [float(row[at]) for row in rows[head + 1 : head + 4]]


def degrees(side: dict[str, Any], key: str = "value_deg") -> list[float]:
    """The angles of a mounting, or their sigmas, in their order."""
    return [angle[key] for angle in side["angles"]]


def test_without_arguments_every_system_is_listed(capsys) -> None:
    text = printed_by(capsys)
    for each in SYSTEMS:
        assert f"\n{each.key} (" in text
    assert text.count("not verified") == sum(each.status == "unverified" for each in SYSTEMS)
    assert text.count("  Assumption ") == sum(bool(each.assumption) for each in SYSTEMS)
    assert [each["system"] for each in run_json(capsys)["systems"]] == [
        each.key for each in SYSTEMS
    ]


def test_to_applanix(capsys) -> None:
    text = printed_by(capsys, 0.4395, -1.8681, 0.3992, "--to", "applanix",
                "--lever-arm", -0.185596, 0.037658, 2.419063)  # fmt: skip
    assert column(text, "Value") == [0.4395, -1.8681, 0.3992]
    assert column(text, "New angles") == [0.4395, 1.8681, 0.3992]
    assert "To Applanix POS MV, LVX, POSPac" in text
    assert "  verified; source: " in text
    assert "X forward -0.1856 m, Y starboard -0.0377 m, Z down -2.4191 m" in text
    assert "is pitched 1.868 deg bow up" in text
    assert "yawed 0.399 deg to starboard" in text


def test_angles_have_names_if_their_order_differs(capsys) -> None:
    text = printed_by(capsys, 0.1, 0.2, 0.3, "--to", "novatel")
    shown = [line.split() for line in text.splitlines() if " rotation  " in line]
    angles = run_json(capsys, 0.1, 0.2, 0.3, "--to", "novatel")["to"]["angles"]
    assert [f"{row[0]} {row[1]}" for row in shown] == ["X rotation", "Y rotation", "Z rotation"]
    assert [angle["name"] for angle in angles] == ["X rotation", "Y rotation", "Z rotation"]
    assert angles[0]["value_deg"] == pytest.approx(-0.2, abs=0.002)
    assert angles[2]["value_deg"] == pytest.approx(-0.3, abs=0.002)


@pytest.mark.parametrize("key", [each.key for each in SYSTEMS if each.status != "verified"])
def test_unverified_systems_are_marked_as_assumed(capsys, key: str) -> None:
    text = printed_by(capsys, 0.1, -0.2, 0.3, "--to", key)
    assert "New angles" not in text
    assert "  Assumption " in text.split("\nTo ")[1]
    assert run_json(capsys, 0.1, -0.2, 0.3, "--to", key)["to"]["assumption"]


def test_conversion_there_and_back_gives_the_same_angles(capsys) -> None:
    for key in ("applanix", "caris", "novatel", "hypack", "opals", "phoenix", "terrascan"):
        there = run_json(capsys, 0.4, -1.9, 0.5, "--lever-arm", 1, -2, 3, "--to", key)["to"]
        back = run_json(capsys, *degrees(there), "--lever-arm", *there["lever_arm_m"],
                        "--from", key)["to"]  # fmt: skip
        assert degrees(back) == pytest.approx([0.4, -1.9, 0.5], abs=1e-9)
        assert back["lever_arm_m"] == pytest.approx([1, -2, 3], abs=1e-9)


def test_negative_and_tiny_numbers_are_accepted(capsys) -> None:
    content = run_json(capsys, "--to", "lispac", "-1e-3", "-.5", "-2")
    assert degrees(content["to"]) == pytest.approx([-0.001, -0.5, -2])


def test_correction_to_present_settings(capsys) -> None:
    words = (0.125, -1.192, 0.276, "--to", "applanix", "--current", 0.1, 1.0, -3)
    text = printed_by(capsys, *words)
    assert column(text, "Current angles") == [0.1, 1.0, -3.0]
    assert column(text, "New angles") == [0.125, 1.192, 0.276]
    assert "Do not add the angles: the sum would be wrong by 0.0101 deg" in text
    found = run_json(capsys, *words)["correction"]
    assert found["side"] == "left"
    turns = {
        name: Rotation.from_euler("ZYX", list(found[name].values())[::-1], degrees=True)
        for name in ("current_deg", "new_deg", "correction_deg")
    }
    product = turns["correction_deg"] * turns["current_deg"]
    assert (product.inv() * turns["new_deg"]).magnitude() < 1e-12
    np.testing.assert_allclose(found["matrix"], turns["correction_deg"].as_matrix(), atol=1e-12)


def test_a_sum_of_angles_that_is_accurate_enough_is_reported(capsys) -> None:
    text = printed_by(capsys, 0.01, -0.02, 0.01, "--to", "applanix", "--current", 0.01, 0.01, 0)
    assert "less than 1 mm at 100 m" in text
    assert "Do not add" not in text


def test_the_current_angles_may_already_be_applied(capsys) -> None:
    words = ("--to", "applanix", "--current", 10, 20, 30)
    nothing = run_json(capsys, 0, 0, 0, *words, "--current-applied")["correction"]
    assert list(nothing["new_deg"].values()) == pytest.approx([10, 20, 30])
    found = run_json(capsys, 0.5, -1.0, 2.0, *words, "--current-applied")["correction"]
    remainder = Rotation.from_euler("ZYX", [2.0, 1.0, 0.5], degrees=True)
    old = Rotation.from_euler("ZYX", [30, 20, 10], degrees=True)
    new = Rotation.from_euler("ZYX", list(found["new_deg"].values())[::-1], degrees=True)
    assert ((remainder * old).inv() * new).magnitude() < 1e-12


def test_the_matrix_for_pdal_and_back(capsys, tmp_path: Path) -> None:
    words = (0.4395, -1.8681, 0.3992, "--lever-arm", -0.185596, 0.037658, 2.419063)
    text = printed_by(capsys, *words, "--to", "pdal")
    rows = text.splitlines()[-4:]
    file = tmp_path / "scan2imu.txt"
    file.write_text("# of the survey\n" + "\n".join(rows))
    back = run_json(capsys, "--from", "pdal", "--from-matrix", file)["to"]
    assert degrees(back) == pytest.approx([0.4395, -1.8681, 0.3992], abs=1e-7)
    assert back["lever_arm_m"] == pytest.approx([-0.185596, 0.037658, 2.419063])
    file.write_text("1,0,0; 0,0,-1; 0,1,0")
    text = printed_by(capsys, "--from-matrix", file)
    assert column(text, "New angles") == [90.0, 0.0, 0.0]
    assert "Lever arm" not in text


@pytest.mark.parametrize("key", ["applanix", "opals", "phoenix", "hypack"])
def test_a_printed_matrix_can_be_read_again(capsys, tmp_path: Path, key: str) -> None:
    there = run_json(capsys, 0.4, -1.9, 0.5, "--lever-arm", 1, -2, 3, "--to", key)["to"]
    file = tmp_path / "matrix.txt"
    file.write_text(json.dumps(there["transform"]))
    back = run_json(capsys, "--from", key, "--from-matrix", file)["to"]
    assert degrees(back) == pytest.approx([0.4, -1.9, 0.5], abs=1e-9)
    assert back["lever_arm_m"] == pytest.approx([1, -2, 3])


def test_axes_of_an_imu_can_be_given(capsys) -> None:
    words = (0, 0, 0, "--lever-arm", 1, 2, 3, "--to", "phoenix")
    content = run_json(capsys, *words, "--body-axes", "down", "starboard", "aft")["to"]
    assert content["lever_arm_m"] == [-3, -2, -1]
    assert "is assumed" not in content["assumption"]
    assert ": X forward, Y port, Z up is assumed" in run_json(capsys, *words)["to"]["assumption"]


def test_a_project_gives_its_estimated_boresight_with_sigmas(
    capsys, calibrated: tuple[Project, Survey]
) -> None:
    project = calibrated[0]
    assert project.result is not None
    content = run_json(capsys, project.folder, "--to", "novatel")
    own = content["from"]
    np.testing.assert_allclose(degrees(own), np.degrees(project.result.boresight))
    np.testing.assert_allclose(degrees(own, "sigma_deg"), np.degrees(project.result.sigma))
    roll, pitch, yaw = degrees(own, "sigma_deg")
    theirs = degrees(content["to"], "sigma_deg")
    # Small angles: X is the pitch, Y the roll.
    assert theirs == pytest.approx([pitch, roll, yaw], rel=0.05)
    assert content["from"]["lever_arm_m"] == pytest.approx(list(project.settings.lever_arm))
    text = printed_by(capsys, project.folder, "--to", "applanix")
    assert text.count("sigma") >= 2
    alone = printed_by(capsys, project.folder)
    assert alone.count("1 sigma") == alone.count("New angles") == 1
    assert re.search("Lever arm +X forward", alone)


def test_gimbal_lock_is_reported(capsys) -> None:
    text = printed_by(capsys, 20, 90, 50, "--to", "applanix")
    assert "The pitch is -90 deg" in text
    assert column(text, "Value") == [20.0, 90.0, 50.0]


def test_refusals(capsys, tmp_path: Path) -> None:
    file = tmp_path / "m.txt"
    for text, words in {
        "1 0 0 0 1 0 0 0 -1": "reflection",
        "2 0 0 0 1 0 0 0 1": "not a rotation",
        "1 2 3": "the matrix has 3 numbers",
        "1 0 0 a 1 0 0 0 1": "3x3 or 4x4",
        "1 0 0 0  0 1 0 0  0 0 1 0  5 6 7 1": "last row",
        "1 0 0 nan  0 1 0 0  0 0 1 0  0 0 0 1": "NaN or infinite",
    }.items():
        file.write_text(text)
        assert words in run_refused(capsys, "--from-matrix", file)
    assert "No such file" in run_refused(capsys, "--from-matrix", tmp_path / "none.txt")
    refused_with("survey.unknown_program", "angles", 1, 2, 3, "--to", "posmv", name="posmv")
    refused_with("survey.matrix_only", "angles", 1, 2, 3, "--to", "pdal", "--current", 1, 2, 3)
    refused_with("survey.matrix_only", "angles", 1, 2, 3, "--from", "riprocess")
    assert "left-handed" in run_refused(capsys, 1, 2, 3, "--to", "hypack", "--scanner", "kept")
    assert "not a direction" in run_refused(capsys, 1, 2, 3, "--to", "phoenix", "--body-axes",
                                            "ahead", "port", "up")  # fmt: skip
    assert command_error("angles", tmp_path).code == "project.not_found"


def test_wrong_usage(capsys, tmp_path: Path) -> None:
    assert "three angles" in run_refused(capsys, 1, 2, code=2)
    assert "three numbers" in run_refused(capsys, 1, "two", 3, code=2)
    assert "finite" in run_refused(capsys, 1, "inf", 3, code=2)
    assert "--current" in run_refused(capsys, 1, 2, 3, "--current-applied", code=2)
    assert "contains its lever arm" in run_refused(capsys, tmp_path, "--lever-arm", 1, 2, 3, code=2)
    assert "give only one of" in run_refused(capsys, 1, 2, 3, "--from-matrix", "x", code=2)


def test_an_uncalibrated_project_is_refused(capsys, demo_project: Project) -> None:
    refused_with("project.not_estimated", "angles", demo_project.folder, "--to", "applanix")


def printed_matrix(capsys, angles, *words) -> list[float]:
    """Numbers of the matrix from scanner to body, as the command prints them."""
    found = run_json(capsys, *angles, "--lever-arm", 0, 0, 0, *words)["from"]["transform"]
    return np.round(np.array(found)[:3, :3], 12).ravel().tolist()


@pytest.mark.parametrize("key", ["applanix", "novatel", "opals", "terrascan", "hypack"])
def test_a_present_matrix_has_the_same_effect_as_present_angles(
    capsys, tmp_path: Path, key: str
) -> None:
    now = (0.1, 1.0, -3.0)
    words = (0.125, -1.192, 0.276, "--to", key)
    numbers = printed_matrix(capsys, now, "--from", key)
    by_angles = run_json(capsys, *words, "--current", *now)["correction"]
    path = tmp_path / "now.txt"
    path.write_text(f"# scanner to body\n{numbers[:3]}\n{numbers[3:6]}\n{numbers[6:]}\n")
    for arguments in (numbers, [path]):
        found = run_json(capsys, *words, "--current-matrix", *arguments)["correction"]
        for name in ("current_deg", "new_deg", "correction_deg"):
            assert found[name] == pytest.approx(by_angles[name], abs=1e-8)
        np.testing.assert_allclose(found["matrix"], by_angles["matrix"], atol=1e-10)
    applied = (*words, "--current-applied")
    np.testing.assert_allclose(
        run_json(capsys, *applied, "--current-matrix", path)["matrix"],
        run_json(capsys, *applied, "--current", *now)["matrix"],
        atol=1e-10,
    )


def test_the_correction_of_a_program_that_accepts_only_a_matrix(capsys) -> None:
    now = Rotation.from_euler("ZYX", [3.0, -1.0, 0.5], degrees=True).as_matrix()
    words = (0.4395, -1.8681, 0.3992, "--to", "pdal")
    numbers = np.round(now, 12).ravel().tolist()
    found = run_json(capsys, *words, "--current-matrix", *numbers)
    new = np.array(found["matrix"])
    np.testing.assert_allclose(np.array(found["correction"]["matrix"]) @ now, new, atol=1e-9)
    assert found["correction"]["new_deg"] is None
    text = printed_by(capsys, *words, "--current-matrix", *numbers)
    assert "new = correction · current" in text
    assert "New 3x3 matrix" in text


def test_the_lever_arm_of_a_present_4x4_matrix_is_kept_or_replaced(capsys, tmp_path: Path) -> None:
    now = np.eye(4)
    now[:3, :3] = Rotation.from_euler("ZYX", [3.0, -1.0, 0.5], degrees=True).as_matrix()
    now[:3, 3] = 0.12, -0.34, 2.5
    numbers = np.round(now, 12).ravel().tolist()
    words = (0.4395, -1.8681, 0.3992, "--to", "applanix", "--current-matrix", *numbers)
    # Without a given lever arm the present one is kept
    found = run_json(capsys, *words)
    assert found["to"]["lever_arm_m"] == pytest.approx([0.12, -0.34, 2.5], abs=1e-12)
    assert found["correction"]["lever_arm"] == "taken over"
    correction, new = (np.array(found[k]["transform"]) for k in ("correction", "to"))
    np.testing.assert_allclose(correction @ now, new, atol=1e-11)
    np.testing.assert_allclose(new[:3, 3], now[:3, 3], atol=1e-12)
    text = printed_by(capsys, *words)
    assert text.count("X forward +0.1200 m, Y starboard -0.3400 m, Z down +2.5000 m") == 2
    assert message_text(note("convention.lever_arm_kept")) in " ".join(text.split())
    printed = text.splitlines()[-4:]
    np.testing.assert_allclose(np.loadtxt(printed), new, atol=1e-10)
    # A given lever arm replaces the present one
    found = run_json(capsys, *words, "--lever-arm", 0.1, 0.3, -2.4)
    assert found["to"]["lever_arm_m"] == pytest.approx([0.1, -0.3, 2.4], abs=1e-12)
    np.testing.assert_allclose(
        np.array(found["correction"]["transform"]) @ now, found["to"]["transform"], atol=1e-11
    )
    text = printed_by(capsys, *words, "--lever-arm", 0.1, 0.3, -2.4)
    assert "X forward +0.1000 m, Y starboard -0.3000 m, Z down +2.4000 m" in text
    assert message_text(note("convention.lever_arm_replaced")) in " ".join(text.split())
    applied = " ".join(printed_by(capsys, *words, "--current-applied").split())
    assert message_text(note("convention.lever_arm_turned")) in applied


def test_an_invalid_present_matrix_is_refused(capsys, tmp_path: Path) -> None:
    words = (1, 2, 3, "--to", "applanix", "--current-matrix")
    assert "Give 9 numbers" in run_refused(capsys, *words, 1, 0, 0)
    assert "not a rotation" in run_refused(capsys, *words, *[1, 0, 0, 0, 2, 0, 0, 0, 1])
    assert "give only one of" in run_refused(
        capsys, *words, *np.eye(3).ravel(), "--current", 1, 2, 3, code=2
    )
