"""Tests of the texts about a boresight and of the assumptions about conventions."""

import re

import numpy as np
import pytest

from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.messages import note
from lispac.survey.conventions.conversion import ConventionSetup
from lispac.survey.conventions.mounting_texts import lever_arm_text, offsets_note, orientation_text
from lispac.survey.conventions.systems import SCANNER_WORDS, SYSTEMS
from lispac.survey.georeferencing import Mounting


def text_of(boresight: np.ndarray) -> str:
    return str(orientation_text(boresight))


def rotations_in(boresight: np.ndarray) -> list[tuple[str, str]]:
    """Angles and directions in the text about a boresight, in their order."""
    return re.findall(r"([\d.]+)° (bow \w+|to \w+|\w+ side up)", text_of(boresight))


def offsets_in(lever_arm: tuple[float, float, float]) -> list[tuple[str, str]]:
    """Distances and directions in the text about a lever arm, in their order."""
    return re.findall(r"([\d.]+) m (?:to )?(\w+)", str(lever_arm_text(lever_arm)))


def test_at_a_steep_pitch_the_text_gives_the_axes() -> None:
    """At a steep pitch, roll and yaw are rotations about almost the same axis."""
    assert "X down, Y port, Z forward" in text_of(np.radians([0.0, 90.0, 0.0]))
    rotation = rotation_matrix(*np.radians([-57.9, 89.3, 58.2]))
    cosine = min(-rotation[2, 0], rotation[1, 1], rotation[0, 2])
    off = f"{np.degrees(np.arccos(cosine)):.3f}"
    assert text_of(rotation_angles(rotation)) == (
        f"Directions of the scanner axes: X down, Y port, Z forward, with deviations up to {off}°."
    )


def test_the_sentence_about_a_boresight() -> None:
    assert rotations_in(np.radians([0.13, -0.12, 0.28])) == [
        ("0.120", "bow up"), ("0.280", "to starboard"), ("0.130", "port side up"),
    ]  # fmt: skip
    assert rotations_in(np.radians([-0.13, 0.12, -0.28])) == [
        ("0.120", "bow down"), ("0.280", "to port"), ("0.130", "starboard side up"),
    ]  # fmt: skip
    assert rotations_in(np.zeros(3)) == []
    assert rotations_in(np.radians([0, 0, 0.0251])) == [("0.0251", "to starboard")]
    assert "(order of rotations: yaw, pitch, roll)" in text_of(np.radians([5, 0, 90]))


def test_angles_have_the_same_number_of_decimals() -> None:
    cases = {
        (0.2, 1.178, 0.3): ["1.178", "0.300", "0.200"],
        (0.0, 1.2, 0.0251): ["1.2000", "0.0251"],
        (1e-6, 1.178, 90.0): ["1.178", "90.000"],
    }
    for angles, expected in cases.items():
        assert [angle for angle, _ in rotations_in(np.radians(angles))] == expected


@pytest.mark.parametrize("sign", [1, -1])
def test_the_text_agrees_with_the_matrix(sign: int) -> None:
    """Directions of the scanner axes in body coordinates forward, left, up."""
    angle = sign * np.radians(1.0)
    forward, left = (
        rotation_matrix(0, angle, 0) @ [1, 0, 0],
        rotation_matrix(angle, 0, 0) @ [0, 1, 0],
    )
    assert ("bow up" in text_of(np.array([0, angle, 0]))) == (forward[2] > 0)
    assert ("port side up" in text_of(np.array([angle, 0, 0]))) == (left[2] > 0)
    turned = rotation_matrix(0, 0, angle) @ [1, 0, 0]
    assert ("to port" in text_of(np.array([0, 0, angle]))) == (turned[1] > 0)


def test_the_sentence_about_a_lever_arm() -> None:
    assert offsets_in((-0.185596, 0.037658, 2.419063)) == [
        ("0.1856", "aft"), ("0.0377", "port"), ("2.4191", "above"),
    ]  # fmt: skip
    assert offsets_in((0, -1.5, -2)) == [("1.500", "starboard"), ("2.000", "below")]
    assert offsets_in((0, 0, 0)) == []


def test_offsets_that_belong_to_the_boresight_are_named() -> None:
    plain = Mounting(np.zeros(3), np.zeros(3))
    assert offsets_note(plain) is None
    with_offsets = Mounting(np.zeros(3), np.zeros(3), range_offset=0.1, latency=0.005)
    found = offsets_note(with_offsets)
    assert found is not None
    assert found == note(
        "convention.offsets",
        offsets=(note("item.range_offset", value=0.1), note("item.latency", value=0.005)),
    )


@pytest.mark.parametrize("convention", SYSTEMS, ids=lambda each: each.key)
def test_unverified_conventions_state_their_assumption(convention) -> None:
    assert convention.source
    if convention.status != "verified":
        assert convention.assumption.endswith(".")
    if convention.has_angles:
        assert sorted(convention.order) == [0, 1, 2]
        assert sorted(turn.axis for turn in convention.turns) == [0, 1, 2]
        for turn in convention.turns:
            assert turn.name in str(convention.formula)


def test_the_assumed_axes_of_the_scanner_are_reported() -> None:
    opals = ConventionSetup(next(each for each in SYSTEMS if each.key == "opals"))
    mounted = str(opals.scanner_axes(rotation_matrix(0.01, 0.02, np.pi / 2)))
    assert mounted.startswith(SCANNER_WORDS["mounted"])
    assert "X starboard, Y forward, Z up" in mounted
    kept = ConventionSetup(next(each for each in SYSTEMS if each.key == "pdal"))
    assert str(kept.scanner_axes(np.eye(3))) == SCANNER_WORDS["kept"]


def test_assumed_axes_are_reported_and_given_axes_are_not() -> None:
    phoenix = next(each for each in SYSTEMS if each.open_axes)
    assert "X forward, Y port, Z up is assumed" in str(ConventionSetup(phoenix).assumption)
    of_given_axes = ConventionSetup(phoenix, ("down", "starboard", "aft")).assumption
    assert "is assumed" not in str(of_given_axes)
