"""Tests that former names of commands, options, keys and fields are accepted for one version."""

import json
from argparse import ArgumentParser
from dataclasses import fields, replace
from pathlib import Path

import pytest

import lispac
from lispac.cli.former_options import FORMER_COMMANDS, FORMER_OPTIONS, with_new_names
from lispac.cli.main import main
from lispac.cli.parser import build_parser
from lispac.former_names import NEW_SCRIPT_NAMES
from lispac.io.config.plan_file import read_site
from lispac.io.config.toml_table import PRESENT_KEY_OF_FORMER
from lispac.io.project.project_file import read_project
from lispac.message_texts.former_codes import REMOVED_CODES
from lispac.messages import error
from lispac.present.calibration.batch import BatchRow
from lispac.project import Settings
from lispac.survey.store import layout
from tests.support.report_sample import sample_project
from tests.support.store_lines import small, stored
from tests.support.trajectory_files import vessel, write_records

__all__ = ["small"]

DATA = Path(__file__).parents[1] / "data"
SITE = Path(__file__).parents[2] / "resources" / "sites" / "quay.toml"


def commands() -> dict[str, ArgumentParser]:
    (found,) = (each.choices for each in build_parser()._actions if each.dest == "command")
    return found  # type: ignore[return-value]


def options_of(command: str) -> set[str]:
    return set(commands()[command]._option_string_actions)


@pytest.mark.parametrize(("former", "new"), FORMER_COMMANDS.items())
def test_a_former_command_is_replaced_with_a_note(
    former: str, new: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert new in commands()
    assert former not in commands()
    assert former not in build_parser().format_help().split()
    assert with_new_names([former, former, "--json"]) == [new, former, "--json"]
    (note,) = capsys.readouterr().err.splitlines()
    assert note.startswith("note: ")
    assert f"{former} is now called {new}." in note


def test_a_former_command_runs_as_the_new_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = write_records(tmp_path / "a.sbet", vessel(500))
    assert main(["inspect", str(path)]) == 0
    expected = capsys.readouterr()
    assert main(["look", str(path)]) == 0
    found = capsys.readouterr()
    assert found.out == expected.out
    assert expected.err == ""
    assert found.err.startswith("note: The command look is now called inspect.")


@pytest.mark.parametrize("command", FORMER_OPTIONS)
def test_a_former_option_is_replaced_with_a_note(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for former, new in FORMER_OPTIONS[command].items():
        assert former not in options_of(command)
        assert new in options_of(command)
        assert with_new_names([command, "a", former, "1"]) == [command, "a", new, "1"]
        assert with_new_names([command, f"{former}=1"]) == [command, f"{new}=1"]
        notes = capsys.readouterr().err.splitlines()
        assert len(notes) == 2
        assert all(each.startswith("note: ") and former in each and new in each for each in notes)
        assert with_new_names([command, new]) == [command, new]
    assert capsys.readouterr().err == ""


def test_an_option_of_another_command_is_not_replaced() -> None:
    assert with_new_names(["export", "--keep"]) == ["export", "--keep"]
    assert with_new_names([]) == []


def test_former_keys_of_a_site_are_read_with_a_warning(tmp_path: Path) -> None:
    former = SITE.read_text(encoding="utf-8")
    used = [(new, old) for old, new in PRESENT_KEY_OF_FORMER.items() if new in former]
    assert len(used) == 3
    for new, old in used:
        former = former.replace(new, old)
    path = tmp_path / "former.toml"
    path.write_text(former, encoding="utf-8")
    with pytest.warns(FutureWarning) as warned:
        _, site = read_site(path)
    assert [each for _, old in used for each in warned if f"key {old} is" in str(each.message)]
    assert len(warned) == 3
    _, present = read_site(SITE)
    assert (site.inclinations_deg, site.headings_deg) == (
        present.inclinations_deg, present.headings_deg,
    )  # fmt: skip


def test_former_parameters_of_scripts_are_accepted(tmp_path: Path) -> None:
    with pytest.warns(FutureWarning, match="accept_single_orientation"):
        settings = Settings((0.0, 0.0, 1.0), accept_one_facing=True)  # type: ignore[call-arg]
    assert settings == Settings((0.0, 0.0, 1.0), accept_single_orientation=True)
    with pytest.warns(FutureWarning, match="accept_single_orientation"):
        assert settings.accept_one_facing  # type: ignore[attr-defined]
    with (
        pytest.warns(FutureWarning, match="resolved"),
        pytest.raises(lispac.LispacError),
    ):
        lispac.new(
            tmp_path / "p", lines=[tmp_path / "a.laz"], trajectory=tmp_path / "t.out",
            lever_arm=(0.0, 0.0, 1.0), settled=True,
        )  # fmt: skip
    with pytest.raises(TypeError, match="unknown"):
        Settings((0.0, 0.0, 1.0), unknown=1)  # type: ignore[call-arg]
    with pytest.raises(AttributeError, match="unknown"):
        settings.unknown  # type: ignore[attr-defined]  # noqa: B018
    with pytest.raises(AttributeError, match="reach"):
        settings.reach  # type: ignore[attr-defined]  # noqa: B018


def test_former_attributes_of_results_are_accepted(tmp_path: Path) -> None:
    result = sample_project(tmp_path).result
    assert result is not None
    rejected = replace(result.reliability[0], rejected=True, outliers=3)
    result = replace(result, reliability=(rejected,), excluded_outliers=7)
    holders = (
        result,
        rejected,
        BatchRow(tmp_path, "p", "refused", (error("estimate.no_target", project="p"),)),
    )
    for holder in holders:
        names = {each.name for each in fields(holder)}  # type: ignore[arg-type]
        former = [old for old, new in NEW_SCRIPT_NAMES.items() if new in names]
        assert former
        for name in former:
            with pytest.warns(FutureWarning, match=NEW_SCRIPT_NAMES[name]):
                found = getattr(holder, name)
            assert found is getattr(holder, NEW_SCRIPT_NAMES[name])
    with pytest.warns(FutureWarning, match="rejected_sightings"):
        assert result.suspects == result.rejected_sightings  # type: ignore[attr-defined]


def test_a_project_of_version_9_has_the_same_values() -> None:
    before = json.loads((DATA / "project-9" / "project.json").read_text(encoding="utf-8"))
    project = read_project(DATA / "project-9")
    result = project.result
    assert result is not None
    former = before["result"]
    assert result.excluded_outliers == former["left_out"] == 7
    assert result.angle_sigma_factors is not None
    assert result.angle_sigma_factors.tolist() == former["raised"]
    assert list(result.given_correlation_times or ()) == former["stated_times"]
    assert [each.outliers for each in result.reliability] == [
        each["strays"] for each in former["reliability"]
    ]
    assert [each.rejected for each in result.reliability] == [
        each["released"] for each in former["reliability"]
    ]
    assert result.reliability[0].rejected
    # stored with the sign of a correction until version 15
    assert [(-each.pos_error).tolist() for each in result.reliability] == [
        each["pos_error"] for each in former["reliability"]
    ]
    (contradiction,) = result.contradictions
    assert contradiction.angle_change.tolist() == former["contradictions"][0]["moved"]
    assert contradiction.surface_sigma == former["contradictions"][0]["surface"]
    assert result.surface == former["surface"]
    assert result.causes is not None
    assert result.causes[0][0].angle_change.tolist() == former["causes"][0][0]["moved"]
    assert result.observability is not None
    codes = [each["code"] for each in former["observability"]["remarks"]]
    kept = [code for code in codes if code not in REMOVED_CODES]
    assert [each.code for each in result.observability.messages] == kept != codes
    assert project.cross_checks is not None
    assert [each.part for each in project.cross_checks.parts] == [
        each["without"] for each in before["cross_checks"]["parts"]
    ]
    planes = project.validation[0].pairs[0].after.planes
    stored = before["validation"][0]["pairs"][0]["after"]["planes"]
    assert planes is not None
    assert (planes.outliers, planes.rotation_horizontal_axis, planes.rotation_slope_axis_95) == (
        stored["strays"], stored["turn_level"], stored["turn_upright_95"],
    )  # fmt: skip
    assert project.absolute is not None
    assert project.absolute.search_distance == before["absolute"]["reach"]
    assert [each.distance for each in project.absolute.other_surfaces or ()] == [
        each["distance"] for each in before["absolute"]["others"]
    ]
    (alternative,) = project.alternative_results
    assert [each.code for each in alternative.messages] == [
        each["code"] for each in before["opinions"][0]["remarks"]
    ]


def test_former_reading_options_of_a_script_are_accepted() -> None:
    options = (("frame", "scanner"), ("time_rollover", "midnight"))
    with pytest.warns(FutureWarning, match="time_rollover"):
        reading = lispac.Reading("las", (options[0], ("restart", "midnight")))
    assert reading == lispac.Reading("las", options)
    with pytest.warns(FutureWarning, match="time_rollover"):
        assert reading.restart == reading.time_rollover == "midnight"  # type: ignore[attr-defined]


def test_a_former_reading_option_at_the_command_line_is_replaced_with_a_note(
    capsys: pytest.CaptureFixture[str],
) -> None:
    command = ["new", "p", "a.laz", "--trajectory", "t", "--lever-arm", "0", "0", "1"]
    options = ["--line-option", "restart=midnight", "--line-option=time_base=utc"]
    found = build_parser().parse_args([*command, *options]).line_option
    assert found == [("time_rollover", "midnight"), ("time_base", "utc")]
    (note,) = capsys.readouterr().err.splitlines()
    assert note.startswith("note: The option restart is now called time_rollover.")


def test_a_project_of_version_10_keeps_the_time_rollover_of_a_line() -> None:
    project = read_project(DATA / "project-10")
    assert project.lines[1].reading == lispac.Reading(
        "las", (("frame", "scanner"), ("time_rollover", "midnight"))
    )
    assert all(line.reading == lispac.Reading() for line in project.lines if line.name != "L2")


@pytest.mark.usefixtures("small")
def test_a_line_stored_with_version_2_is_read(tmp_path: Path) -> None:
    now = stored(tmp_path / "L1").manifest
    path = tmp_path / "L1" / layout.MANIFEST_FILE
    content = json.loads(path.read_text(encoding="utf-8"))
    store = content["store"]
    store["left_out"] = store.pop("excluded_points")
    former = {"version": 2, "checksum": layout._checksum(store), "store": store}
    path.write_text(json.dumps(former), encoding="utf-8")
    assert now.excluded_points > 0
    assert layout.read_manifest(tmp_path / "L1") == now


@pytest.mark.usefixtures("small")
def test_a_line_stored_with_former_reading_options_is_read(tmp_path: Path) -> None:
    now = stored(tmp_path / "L1").manifest
    reading = {"format": "las", "options": [["time_rollover", "none"]], "time_shift": 0.0}
    now = replace(now, made_with={**now.made_with, "reading": reading})
    former = {**reading, "options": [["restart", "none"]]}
    layout.write_manifest(
        tmp_path / "L1", replace(now, made_with={**now.made_with, "reading": former})
    )
    assert layout.read_manifest(tmp_path / "L1") == now
