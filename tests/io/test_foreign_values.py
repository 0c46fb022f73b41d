"""Tests of the checks of values and texts from files, and of their display as text."""

import json
import os
import sys
from argparse import ArgumentTypeError
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.adjustment.model.parameters import Parameter
from lispac.cli.argument_types import finite_number, number_within
from lispac.cli.main import main
from lispac.errors import InputError, LispacError, ProjectError
from lispac.io.config.toml_table import TomlTable, toml_string
from lispac.io.files import atomic_write
from lispac.io.formats import format_of
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.project import Project, Settings
from lispac.survey.store.layout import read_manifest, write_manifest
from lispac.untrusted_values import (
    InvalidContentError,
    as_csv_cell,
    is_whole_number,
    json_values,
    toml_values,
)
from lispac.warning_causes import Cause
from lispac.workflow.importing.line_import import import_lines, line_folder
from lispac.workflow.planning.plan_checks import write_scenarios
from lispac.workflow.planning.simulate import replaced_survey
from lispac.workflow.project.survey import load_survey
from tests.support.long_runs import LONG, others_long


@pytest.mark.parametrize(
    "text",
    [
        "[" * 100 + "]" * 100, "[" * 100_000, "9" * 5000, str(2**63), '"\\u0000"', '"\\ud800"',
        '{"a": [{"b\\u0000": 1}]}', "{", b"\xff\xfe",
    ],
)  # fmt: skip
def test_unusable_json_is_refused(text: str | bytes) -> None:
    with pytest.raises(InvalidContentError):
        json_values(text)


@pytest.mark.parametrize(
    "text",
    [b"a = " + b"[" * 3000, b"a = " + b"9" * 5000, b'a = "\\u0000"', b"a = 1\na = 2", b"a = \xff"],
)
def test_unusable_toml_is_refused(text: bytes) -> None:
    with pytest.raises(InvalidContentError):
        toml_values(text)


def test_usable_values_are_returned_unchanged() -> None:
    values = {"a": [1, 2.5, None, True, {"b": "L\u00e9v\u00e9"}], "path": "x\udcff", "n": -(2**62)}
    assert json_values(json.dumps(values)) == values
    assert toml_values(b'a = [1, "b"]\n') == {"a": [1, "b"]}


@pytest.mark.parametrize(
    ("value", "cell"),
    [
        ("=1+1", "'=1+1"), ("+cmd", "'+cmd"), ("-L1", "'-L1"), ("@x", "'@x"), ("\tx", "'\tx"),
        ("-0.25", "-0.25"), ("+1,234.5", "+1,234.5"), (-3.5, "-3.5"), ("L1", "L1"), (None, ""),
        ("-1e-5", "-1e-5"),
    ],
)  # fmt: skip
def test_cells_that_look_like_formulas_are_escaped(value: object, cell: str) -> None:
    assert as_csv_cell(value) == cell


def test_a_message_is_one_line_of_text() -> None:
    text = str(LispacError("a\nb\x1b[31m\r\x00\x9bc: wrong."))
    assert text.isprintable()
    assert "wrong." in text


@pytest.mark.parametrize(
    "values",
    [
        {"position_time": 1e-320}, {"attitude_time": 1e300}, {"subsample": 1e-300},
        {"lidar_sigma": 1e5}, {"lidar_beam_sigma": (1e31, 1.0)},
        {"lidar_beam_sigma": (0.01, 1e-320)},
        {"position_sigma": (1e5, 0.1, 0.1)}, {"longest_gap": 1e-12},
    ],
)  # fmt: skip
def test_settings_beyond_what_is_possible_are_refused(values: dict[str, object]) -> None:
    with pytest.raises(InputError):
        Settings((0.0, 0.0, 0.0), **values).require_sound()  # type: ignore[arg-type]
    Settings((0.0, 0.0, 0.0)).require_sound()


@LONG
def test_implausible_standard_deviations_give_a_warning(copy: Project) -> None:
    def codes() -> list[str]:
        return [message.code for message in load_survey(copy).messages]

    assert "accuracy.too_large" not in codes()
    assert copy.accuracy is not None
    records = np.fromfile(copy.accuracy).reshape(-1, 10)
    records[5, 1:4] = 2e4
    records.tofile(copy.accuracy)
    assert "accuracy.too_large" in codes()


def test_a_copy_has_a_separate_folder(copy: Project) -> None:
    assert copy.accuracy is not None
    assert Path(copy.accuracy).is_relative_to(copy.folder), "the test above changes it"


@LONG
@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere names of files are Unicode")
@pytest.mark.parametrize("ending", others_long(["pdf", "html", "json"]))
def test_reports_of_folders_whose_names_are_not_utf8(copy: Project, ending: str) -> None:
    folder = copy.folder.rename(copy.folder.with_name(os.fsdecode(b"quay\xff")))
    report = folder.parent / f"report.{ending}"
    assert main(["report", str(folder), "--output", str(report)]) == 0
    assert report.stat().st_size > 1000


WRONG_VALUES = [
    ("validation/0/pairs/1/after/planes/rotation_horizontal_axis_95", "/dev/zero"),
    ("validation/0/pairs/1/before/distances/outliers", float("nan")),
    ("validation/0/pairs/0/before/distances/n", {}),
    ("validation/0/pairs/0/before/distances/mean", True),
    ("validation/0/counts_after", [[]]),
    ("validation/0/counts_after", [1, 2]),
    ("validation/0/maps/0/after", 0),
    ("validation/0/maps/0/after", [1.0]),
    ("validation/0/not_compared", "ab"),
    ("result/observability/directions", [0, 0, 0]),
    ("result/observability/eigenvalues", "nan"),
    ("result/mounting/boresight", [1.0, 2.0]),
    ("result/sightings/0/sighting/line", "<img src=x>"),
    ("result/reliability/0/sighting/target", [[]]),
    ("result/raised", True),
    ("result/variance_factor", 1e308),
    ("truth_deg", "abc"),
    ("truth_deg", [1, 2]),
]
"""Places in a project file, and invalid values for them."""


@pytest.mark.parametrize(("place", "value"), WRONG_VALUES)
def test_invalid_values_of_a_project_are_refused(copy: Project, place: str, value: object) -> None:
    path = copy.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    *folders, last = place.split("/")
    inner: Any = content
    for name in folders:
        inner = inner[int(name) if name.isdigit() else name]
    inner[last] = value
    path.write_text(json.dumps(content))
    with pytest.raises(ProjectError):
        read_project(copy.folder)


@pytest.mark.parametrize("name", ["a\0b.csv", "a\ud800b.csv"])
def test_impossible_file_names_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError) as refused, atomic_write(tmp_path / name):
        pass
    assert refused.value.code == "file.bad_name"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["a\0b", "a\ud800b"])
def test_impossible_folder_names_are_refused(copy: Project, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "empty" / name
    folder.parent.mkdir()
    with pytest.raises(InputError) as refused:
        write_project(replace(copy, folder=folder))
    assert refused.value.code == "file.bad_name"
    with pytest.raises(InputError) as refused, replaced_survey(folder, "mark", "text", ()):
        pass
    assert refused.value.code == "file.bad_name"
    with pytest.raises(InputError) as refused:
        write_scenarios(folder, ())
    assert refused.value.code == "file.bad_name"
    assert not list(folder.parent.iterdir())


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no named pipes in folders")
def test_a_pipe_or_folder_is_not_overwritten(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "folder.csv").mkdir()
    for name, code in (("pipe.csv", "file.is_device"), ("folder.csv", "file.is_folder")):
        with pytest.raises(InputError) as refused, atomic_write(tmp_path / name):
            pass
        assert refused.value.code == code
    assert (tmp_path / "pipe.csv").is_fifo()


def test_files_that_look_like_temporary_files_are_kept(tmp_path: Path) -> None:
    file_of_user = tmp_path / ".report-20260101.pdf"
    file_of_user.write_text("mine")
    os.utime(file_of_user, (0, 0))
    with atomic_write(tmp_path / "report.pdf") as temporary:
        temporary.write_text("report")
    assert file_of_user.exists()


@pytest.mark.parametrize("text", ["9" * 5000, "-1", "", "1.5", "1_0", str(2**63)])
def test_invalid_counts_in_text_are_recognised(text: str) -> None:
    assert not is_whole_number(text, 1 << 48)
    assert is_whole_number("12", 1 << 48)


@pytest.mark.parametrize("text", ["1e-320", "1e31", "-1e300", "inf", "nan"])
def test_impossible_numbers_of_options_are_refused(text: str) -> None:
    for kind in (finite_number, number_within(1e-6, 100.0)):
        with pytest.raises(ArgumentTypeError):
            kind(text)


@pytest.mark.parametrize("text", ["a\nb", "a\tb", "\x1b[31m", "a\x7fb", "a\u2028b", '"\\', "é 😀"])
def test_texts_of_a_settings_file_must_have_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(f"title = {toml_string(text)}\n", encoding="utf-8")
    assert toml_values(path.read_bytes()) == {"title": text}
    with TomlTable.read(path, "plan") as table:
        if text.isprintable():
            assert table.text("title") == text
            return
        with pytest.raises(InputError) as refused:
            table.text("title")
    assert refused.value.code == "toml.control_character"


@pytest.mark.parametrize("value", ["1e-320", "1e300", "-1e300"])
def test_impossible_numbers_of_a_settings_file_are_refused(tmp_path: Path, value: str) -> None:
    path = tmp_path / "made.toml"
    path.write_text(f"a = {value}\n")
    with pytest.raises(InputError), TomlTable.read(path, "scene") as table:
        table.number("a")


def test_prior_standard_deviations_beyond_what_is_possible_are_refused() -> None:
    for sigma in (1e-320, 1e31):
        with pytest.raises(InputError) as refused:
            Settings(
                (0.0, 0.0, 0.0), parameters=(Parameter("range_offset", sigma),)
            ).require_sound()
        assert refused.value.code == "settings.parameter_sigma_out_of_range"


def test_a_ply_header_with_thousands_of_digits_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.ply"
    digits = "9" * 5000
    path.write_text(
        f"ply\nformat ascii 1.0\nelement vertex {digits}\nproperty float x\nend_header\n"
    )
    with pytest.raises(InputError):
        format_of("ply").preview(path, {})


def test_records_with_denormal_times_raise_no_other_error(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    records = np.random.default_rng(0).uniform(-1.0, 1.0, (200, 17))
    records[:, 0] = np.arange(200) * 5e-324
    records.tofile(path)
    try:
        format_of("sbet").preview(path, {})
    except InputError:
        return


@LONG
def test_stored_points_beyond_the_range_of_the_scanner_give_a_warning(copy: Project) -> None:
    import_lines(copy)
    line = copy.lines[0]

    def codes() -> list[str]:
        messages = load_survey(copy).messages
        return [m.code for m in messages if m.subject == Cause.of_line(line.name)]

    assert "audit.beyond_range" not in codes()
    folder = line_folder(copy, line)
    manifest = read_manifest(folder)
    assert manifest is not None
    write_manifest(folder, replace(manifest, reach=17e3))
    assert "audit.beyond_range" in codes()
