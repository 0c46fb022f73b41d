"""Tests of the survey details: project file, command line and report."""

import csv
import json
import shutil
import zipfile
from dataclasses import asdict, replace
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError, ProjectError
from lispac.identity import (
    EMPTY_IDENTITY,
    FIELD_GROUPS,
    FIELD_HINTS,
    FIELD_LABELS,
    FIELD_NAMES,
    Identity,
)
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.message_texts import TEXTS
from lispac.messages import error, note
from lispac.project import LineSource, Project, Reading
from lispac.report.csv_tables import write_tables
from lispac.report.document import report_document
from lispac.report.html import html_text
from lispac.report.options import Extent, ReportOptions
from lispac.report.pdf import write_pdf
from lispac.workflow.project.survey_dates import survey_dates
from tests.cli.test_cli import run
from tests.report.test_report import _pdf_text
from tests.support.command_errors import command_error
from tests.support.long_runs import others_long
from tests.support.report_sample import sample_content, sample_project

FULL = Identity(
    report_number="R-0412",
    revision="2",
    client="Port Authority",
    contract="C-77/2026",
    company="Levés du Fleuve inc.",
    surveyor="Ève Tremblay",
    processed_by="Luc Roy",
    checked_by="Ana Ruiz",
    vessel="F. J. Saucier",
    site="Port of Quebec",
    scanner="Profiler 16",
    scanner_serial="AG-38204719",
    pos="Inertial C",
    pos_serial="1,218",
    dates="2026-03-04 to 2026-03-05",
    datum="NAD83(CSRS)v7",
    epoch="2010.0",
    gnss_base="base LEV2",
    processing_software="Example 9.1",
    lever_arm_origin="tacheometer in dock, 2026-03-04",
    remarks="Wind from the west.\nL4 was run twice.",
)


def test_every_field_has_a_name_and_a_hint() -> None:
    assert tuple(name for _, names in FIELD_GROUPS for name in names) == FIELD_NAMES
    assert tuple(FIELD_LABELS) == tuple(FIELD_HINTS) == FIELD_NAMES == tuple(asdict(FULL))
    assert all(asdict(FULL).values())


def test_details_are_saved_and_keep_the_results(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    changed = project.with_identity(FULL)
    assert changed.result is project.result
    assert changed.validation is project.validation
    write_project(changed)
    assert read_project(project.folder).identity == FULL


@pytest.mark.parametrize(
    ("texts", "code", "params"),
    [
        ({"vessel": "two\nlines"}, "several_lines", {}),
        ({"site": "a\x07b"}, "not_printable", {}),
        ({"scanner_serial": "7" * 201}, "too_long", {"held": 201, "longest": 200}),
        ({"remarks": "7" * 2001}, "too_long", {"held": 2001, "longest": 2000}),
        ({"dates": "2026-13-45"}, "no_date", {"text": "2026-13-45"}),
        ({"dates": "2026-02-28 to 2026-02-30"}, "no_date", {"text": "2026-02-30"}),
        ({"dates": "2026/3/0"}, "no_date", {"text": "2026/3/0"}),
        ({"dates": "31/31/2026"}, "no_date", {"text": "31/31/2026"}),
        ({"dates": "1 and 30.2.2026"}, "no_date", {"text": "30.2.2026"}),
        ({"dates": "2026-11-2x"}, "no_date", {"text": "2026-11-2x"}),
        ({"epoch": "2010-00-01"}, "no_date", {"text": "2010-00-01"}),
    ],
)
def test_texts_that_cannot_be_printed_are_refused(
    texts: dict[str, str], code: str, params: dict[str, int | str]
) -> None:
    with pytest.raises(InputError) as refused:
        FULL.changed(**texts)
    (name,) = texts
    field = note(f"identity_field.{name}")
    assert refused.value.message == error(f"identity.{code}", field=field, **params)


@pytest.mark.parametrize(
    "texts",
    [
        {"dates": "2028-02-29"},
        {"dates": "4 and 5 March 2026"},
        {"dates": "2026-03-04/05"},
        {"dates": "29/02/2028 to 03/13/2028"},
        {"site": "31/31/2026"},
        {"remarks": "31/31/2026"},
        {"dates": ""},
        {"epoch": "2010.0"},
        {"scanner_serial": "2026-13-45"},
    ],
)
def test_dates_that_exist_and_other_texts_are_accepted(texts: dict[str, str]) -> None:
    assert texts.items() <= asdict(FULL.changed(**texts)).items()


def test_a_stored_date_that_does_not_exist_closes_no_project() -> None:
    replace(FULL, dates="2026-13-45").require_sound()


def test_every_field_has_a_name_in_messages() -> None:
    fields = [code for code in TEXTS if code.startswith("identity_field.")]
    assert fields == [f"identity_field.{name}" for name in FIELD_NAMES]


def test_surrounding_blanks_are_removed(tmp_path: Path) -> None:
    assert EMPTY_IDENTITY.changed(vessel="  F. J. Saucier \n").vessel == "F. J. Saucier"


def test_an_invalid_text_in_a_project_file_is_refused(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_project(project)
    path = project.folder / PROJECT_FILE_NAME
    content = json.loads(path.read_text())
    content["identity"]["vessel"] = "\x01"
    path.write_text(json.dumps(content))
    with pytest.raises(ProjectError) as refused:
        read_project(project.folder)
    field = note("identity_field.vessel")
    assert refused.value.message == error(
        "project.invalid_value", file=str(path),
        reason=error("identity.not_printable", field=field),
    )  # fmt: skip


def test_the_command_sets_given_fields_and_shows_all(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "p"
    write_project(sample_project(folder))
    words = ["--surveyor", FULL.surveyor, "--lever-arm-origin", FULL.lever_arm_origin]
    assert main(["identity", str(folder), *words]) == 0
    shown = capsys.readouterr().out.splitlines()
    assert [line.split("  ")[0] for line in shown] == list(FIELD_LABELS.values())
    assert f"Surveyor                 {FULL.surveyor}" in shown
    assert main(["identity", str(folder), "--vessel", "Saucier", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert {name: text for name, text in values.items() if text} == {
        "schema_version": 1, "surveyor": FULL.surveyor, "vessel": "Saucier",
        "lever_arm_origin": FULL.lever_arm_origin,
    }  # fmt: skip
    assert main(["identity", str(folder), "--vessel", ""]) == 0
    assert read_project(folder).identity.vessel == ""
    capsys.readouterr()
    refusal = command_error("identity", folder, "--vessel", "a\tb")
    assert refusal.message == error("identity.not_printable", field=note("identity_field.vessel"))


@pytest.mark.parametrize("extent", others_long(["short", "full"]))
def test_each_detail_is_printed_once_and_vessel_and_company_on_every_page(
    tmp_path: Path, extent: Extent
) -> None:
    project = sample_project(tmp_path / "p").with_identity(FULL)
    options = ReportOptions(extent=extent)
    write_pdf(sample_content(project), tmp_path / "full.pdf", {}, options)
    first, *others = _pdf_text(tmp_path / "full.pdf").rstrip("\f").split("\f")
    assert all(
        text in page
        for page in others
        for text in (FULL.vessel, FULL.company, FULL.report_number, f"revision {FULL.revision}")
    )
    bodies = "\n".join([first, *(page.split("\n", 1)[1] for page in others)])
    for name, text in asdict(FULL).items():
        longest = max(text.splitlines(), key=len)
        if len(longest) > 3:
            assert bodies.count(longest) == 1, name
    labels = set(FIELD_LABELS) - {"company"}  # the company is in the letterhead
    if extent == "short":  # the serial numbers follow the instruments
        labels -= {"scanner_serial", "pos_serial"}
    assert all(FIELD_LABELS[name] in bodies for name in labels)
    assert first.index(FULL.company) < first.index(FULL.vessel) < first.index("CALIBRATED")
    assert first.index("CALIBRATED") < first.index(FULL.contract)


def test_blank_details_are_printed_in_the_full_report_only(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    one = sample_content(project.with_identity(replace(FULL, vessel="")))
    assert html_text(one, {}, ReportOptions(extent="full")).count("<dd></dd>") == 1
    short = report_document(one, {})
    names = [name for name, _ in short.identity.rows]
    assert FIELD_LABELS["client"] in names
    assert FULL.site in short.project
    assert FIELD_LABELS["vessel"] not in names
    blank = report_document(sample_content(project), {}, ReportOptions(extent="full"))
    assert {value for _, value in blank.identity.rows} == {""}
    assert report_document(sample_content(project), {}).identity.rows == ()


def test_a_letterhead_of_another_company_does_not_replace_the_company(tmp_path: Path) -> None:
    content = sample_content(sample_project(tmp_path / "p").with_identity(FULL))
    for letterhead, shown in (("Another company", True), (f"{FULL.company}\nQuay 1", False)):
        document = report_document(content, {}, ReportOptions(company=letterhead))
        assert document.letterhead.company == letterhead
        assert ((FIELD_LABELS["company"], FULL.company) in document.identity.rows) == shown


def test_details_are_exported_as_a_table(tmp_path: Path) -> None:
    content = sample_content(sample_project(tmp_path / "p").with_identity(FULL))
    write_tables(content, tmp_path / "r.zip")
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        text = archive.read("01-details-of-the-survey.csv").decode("utf-8-sig")
    values = dict(csv.reader(text.splitlines()))
    assert list(values) == list(FIELD_LABELS.values())
    assert values["INS/GNSS serial number"] == "1,218"  # a text, though it looks like a number


def _adjusted(*moment: int) -> float:
    """Return adjusted standard GPS time by its definition: 18 leap seconds since 2017."""
    at = datetime(*moment, tzinfo=UTC)  # type: ignore[arg-type, misc]
    return (at - datetime(1980, 1, 6, tzinfo=UTC)).total_seconds() + 18 - 1e9


def _line(path: Path, times: list[float], *, absolute: bool) -> LineSource:
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.global_encoding.gps_time_type = (
        laspy.header.GpsTimeType.STANDARD if absolute else laspy.header.GpsTimeType.WEEK_TIME
    )
    las = laspy.LasData(header)
    las.x = las.y = las.z = np.arange(len(times), dtype=float)
    las.gps_time = np.array(times)
    las.write(path)
    return LineSource(path.stem, path)


def test_survey_dates_are_taken_from_absolute_times(tmp_path: Path, demo_folder: Path) -> None:
    evening, night = _adjusted(2026, 3, 4, 23, 59, 58), _adjusted(2026, 3, 5, 0, 0, 1)
    demo = read_project(demo_folder)
    one = _line(tmp_path / "one.las", [evening - 5, evening], absolute=True)
    two = _line(tmp_path / "two.las", [night, night + 5], absolute=True)
    week = _line(tmp_path / "week.las", [259_200.0, 259_210.0], absolute=False)
    # Headers often specify adjusted time though the times are seconds of the week.
    contradictory = _line(tmp_path / "contradictory.las", [259_200.0, 259_210.0], absolute=True)

    def days(*lines: LineSource) -> str:
        return survey_dates(replace(demo, lines=lines))

    assert days(one) == "2026-03-04"
    assert days(one, two) == "2026-03-04 to 2026-03-05"
    assert days(two, week) == days(contradictory) == ""
    assert days(replace(one, path=tmp_path / "gone.las")) == ""


def test_survey_dates_are_taken_from_shifted_times(tmp_path: Path, demo_folder: Path) -> None:
    noon = _adjusted(2026, 3, 4, 12)
    to_week = -456_358_400.0  # from adjusted GPS time to seconds of the GPS week 2408
    line = _line(tmp_path / "one.las", [noon, noon + 60], absolute=True)
    line = replace(line, reading=Reading(time_shift=to_week))
    first, last = noon + to_week, noon + to_week + 60
    survey = SimpleNamespace(scans={"one": SimpleNamespace(first_time=first, last_time=last)})
    project = replace(read_project(demo_folder), lines=(line,))
    assert 0 < first < 604_800
    assert survey_dates(project, survey) == "2026-03-04"  # type: ignore[arg-type]
    assert survey_dates(project) == "2026-03-04"


@pytest.fixture
def demo_folder(demo_project, tmp_path: Path) -> Path:
    return Path(shutil.copytree(demo_project.folder, tmp_path / "demo"))


def test_automatic_dates_are_refused_without_absolute_times(demo_folder: Path) -> None:
    assert command_error("identity", demo_folder, "--dates", "auto").code == "cli.no_dates"


def test_automatic_dates_are_taken_from_the_times(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    noon = _adjusted(2026, 3, 4, 12)
    line = _line(tmp_path / "one.las", [noon, noon + 60], absolute=True)
    sample = sample_project(tmp_path / "p")
    write_project(
        Project(
            folder=sample.folder,
            trajectory=sample.trajectory,
            lines=(line,),
            settings=sample.settings,
        )
    )
    code, out, err = run(capsys, "identity", tmp_path / "p", "--dates", "auto")
    assert (code, err) == (0, "")
    assert "Survey dates             2026-03-04\n" in out
    assert read_project(tmp_path / "p").identity.dates == "2026-03-04"


def test_dates_without_a_day_are_reported(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    folder = sample_project(tmp_path / "harbour").folder
    write_project(sample_project(folder))
    code, _, err = run(capsys, "identity", folder, "--dates", "March 2026")
    assert code == 0
    assert "the survey dates (March 2026) contain no date of the form 2026-03-04" in err
    _, _, err = run(capsys, "identity", folder, "--dates", "2026-03-04 and 2026-03-05")
    assert err == ""
