"""Tests of the options of the report: page size, convention of the values, company template."""

import csv
import json
import re
import textwrap
import tomllib
import zipfile
from dataclasses import asdict, replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError
from lispac.identity import EMPTY_IDENTITY
from lispac.message_texts import message_text
from lispac.messages import Level, note
from lispac.project import Project
from lispac.report.content import ReportContent
from lispac.report.csv_tables import write_tables
from lispac.report.html import html_text
from lispac.report.options import DEFAULT_OPTIONS, Page, ReportOptions
from lispac.report.pdf import write_pdf
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    convert_from_system,
    mounting_of_angles,
)
from lispac.survey.conventions.mounting_texts import CHECK_FIRST_NOTE, UNCORRELATED_WARNING
from lispac.survey.conventions.systems import SYSTEMS, convention_of_key
from lispac.survey.georeferencing import Mounting
from lispac.workflow.output.report_options import TEMPLATE_KEYS, report_options
from tests.report.test_identity import FULL
from tests.report.test_report import _page, _pdf_text
from tests.support.command_errors import codes_of, is_refusal, refused_with
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

LOGO = (
    b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10">'
    b'<rect width="20" height="9"/></svg>'
)
TEMPLATE = '''
logo = "art/logo.svg"
company = """Levés du Fleuve inc.
12, rue du Quai"""
heading = "Order 4711"
closing = "Valid until an instrument is moved."
page = "Letter"
convention = "Applanix"
extent = "full"
'''
LEVER_ARM = np.array([-0.1856, 0.0377, 2.4191])


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    made = sample_project(tmp_path_factory.mktemp("options") / "harbour")
    assert made.result is not None
    mounting = Mounting(LEVER_ARM, made.result.mounting.boresight)
    return replace(made, result=replace(made.result, mounting=mounting))


@pytest.fixture
def template(tmp_path: Path) -> Path:
    (tmp_path / "art").mkdir()
    (tmp_path / "art" / "logo.svg").write_bytes(LOGO)
    path = tmp_path / "fleuve.toml"
    path.write_text(TEMPLATE, encoding="utf-8")
    return path


def _content(project: Project, key: str) -> ReportContent:
    return sample_content(project, convention=key)


def test_a_template_has_the_settings_of_a_company(template: Path) -> None:
    options = report_options(template)
    assert options == ReportOptions(
        "letter", "applanix", logo=template.parent / "art" / "logo.svg",
        company="Levés du Fleuve inc.\n12, rue du Quai", heading="Order 4711",
        closing="Valid until an instrument is moved.", extent="full",
    )  # fmt: skip
    assert set(TEMPLATE_KEYS) == set(asdict(options))
    chosen = report_options(template, "a4", "qinsy")
    assert (chosen.page, chosen.convention, chosen.extent) == ("a4", "qinsy", "full")
    assert report_options(template, extent="short").extent == "short"
    template.write_text(TEMPLATE + 'language = "FR"', encoding="utf-8")
    assert report_options(template).language == "fr"
    assert report_options(template, language="en").language == "en"
    assert report_options() == DEFAULT_OPTIONS
    assert DEFAULT_OPTIONS.extent == "short"


@pytest.mark.parametrize("language", ["en", "fr"])
def test_the_template_of_the_manual_is_valid(language: str, tmp_path: Path) -> None:
    checkout = Path(__file__).resolve().parents[2]
    manual = checkout / "resources" / "manual" / language / "report.md"
    blocks = re.findall(r"(?:^ {4}.*\n)+", manual.read_text(encoding="utf-8"), re.MULTILINE)
    (text,) = (textwrap.dedent(block) for block in blocks if "logo" in block)
    (tmp_path / "logo.svg").write_bytes(LOGO)
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    options = report_options(tmp_path / "own.toml")
    assert all(asdict(options).values())
    assert set(tomllib.loads(text)) == set(TEMPLATE_KEYS)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("colour = 'red'", "report_template.unknown_key"),
        ("page = 'a5'", "report_template.no_page"),
        ("page = 4", "report_template.not_text"),
        ("language = 'de'", "report_template.no_language"),
        ("extent = 'long'", "report_template.no_extent"),
        ("convention = 'lidarsoft'", "survey.unknown_program"),
        ("company = Fleuve", "report_template.not_toml"),
        ("logo = 'none.png'", "file.not_found"),
        ("logo = 'own.toml'", "report_template.logo_format"),
        ('heading = "a\\u0007b"', "report_template.long_text"),
    ],
)
def test_an_invalid_template_is_refused(tmp_path: Path, text: str, code: str) -> None:
    path = tmp_path / "own.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as refusal:
        report_options(path)
    assert is_refusal(refusal.value, code)
    assert str(refusal.value).startswith(str(path))
    assert "\n" not in str(refusal.value)


def test_a_missing_or_binary_template_is_refused(tmp_path: Path) -> None:
    missing = has_code("file.not_found", kind=note("file.kind_report_template"))
    with pytest.raises(InputError, check=missing):
        report_options(tmp_path / "gone.toml")
    (tmp_path / "odd.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError) as raised:
        report_options(tmp_path / "odd.toml")
    assert raised.value.code == "report_template.not_toml"


def test_an_invalid_logo_is_named(
    demo_project: Project, template: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    logo = template.parent / "art" / "logo.svg"
    logo.write_bytes(b"<svg><rect")
    output = tmp_path / "r.pdf"
    words = ["report", demo_project.folder, "--output", output, "--template", template]
    refusal = refused_with("report.picture_invalid", *words, file=str(logo))
    assert ".pdf" not in str(refusal)
    assert not output.exists()


@LONG
@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_letterhead_and_texts_are_in_pdf_and_html(
    project: Project, template: Path, tmp_path: Path
) -> None:
    options = report_options(template)
    content = _content(project, options.convention)
    write_pdf(content, tmp_path / "r.pdf", {}, options)
    first = _pdf_text(tmp_path / "r.pdf", "-f", "1", "-l", "1")
    places = [
        first.index(text)
        for text in ("12, rue du Quai", "Order 4711", "CALIBRATED", "Valid until", "Signature")
    ]
    assert places == sorted(places)
    page = _page(html_text(content, {}, options))
    words = "".join(page.words)
    assert all(text in words for text in ("12, rue du Quai", "Order 4711", "Valid until"))
    assert page.sources[0].startswith("data:image/svg+xml;base64,")


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize(
    ("blank", "language", "page"),
    [
        (True, "fr", "a4"),
        *(
            pytest.param(*each, marks=pytest.mark.long)
            for each in product((True, False), ("en", "fr"), ("a4", "letter"))
        ),
    ],
)
def test_page_one_has_the_signature(
    project: Project, template: Path, tmp_path: Path, page: Page, language: str, blank: bool
) -> None:
    options = report_options(template, page, language=language)
    content = sample_content(project.with_identity(EMPTY_IDENTITY if blank else FULL))
    sentence = (
        "The angles were estimated once more with other targets, and the answer stayed as it was."
    )
    messages = tuple(
        note("report.not_compared", reason=f"{k}: {sentence} Nothing else is known.")
        for k in range(4)
    )
    content = replace(content, warnings=messages)
    plane = content.validation[0]
    content = replace(content, validation=tuple(replace(plane, name=f"V{k}") for k in range(1, 6)))
    path = tmp_path / "r.pdf"
    write_pdf(content, path, {}, options)
    pages = [re.sub(r"\s+", " ", text) for text in _pdf_text(path).split("\f")]
    # The box of notes is not divided; it is on page two if page one would have small letters.
    assert any(all(f"{k}: {sentence}" in text for k in range(4)) for text in pages[:2])
    assert re.search("Place and date|Lieu et date", pages[0])
    # Many notes continue on the next page; many warnings move the signature and the text above it.
    serious = tuple(replace(each, level=Level.WARNING) for each in messages)
    for many, moves in ((messages, False), (serious, True)):
        write_pdf(replace(content, warnings=many * 10), path, {}, options)
        pages = _pdf_text(path).split("\f")
        (at,) = (
            k for k, text in enumerate(pages) if re.search("Place and date|Lieu et date", text)
        )
        assert (at > 0) == moves
        assert "Valid until an instrument is moved." in pages[at]


@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_pages_have_the_chosen_size(project: Project, tmp_path: Path) -> None:
    content = sample_content(project)
    boxes = {}
    for page in ("a4", "letter"):
        options = replace(DEFAULT_OPTIONS, page=page)
        write_pdf(content, tmp_path / f"{page}.pdf", {}, options)
        data = (tmp_path / f"{page}.pdf").read_bytes()
        boxes[page] = {
            tuple(map(float, box.split())) for box in re.findall(rb"/MediaBox ?\[([^]]*)\]", data)
        }
        assert f"size: {'A4' if page == 'a4' else 'letter'};" in html_text(content, {}, options)
    (a4,), (letter,) = boxes["a4"], boxes["letter"]
    # 210 by 297 mm, and 8.5 by 11 inches, at 72 points an inch
    assert a4[2:] == pytest.approx((210 / 25.4 * 72, 297 / 25.4 * 72), abs=0.01)
    assert letter[2:] == (612, 792)


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize(
    ("finished", "line_count", "page"),
    others_long(
        [
            (True, 25, "letter"),
            (False, 0, "a4"),
            (True, 0, "a4"),
            (False, 4, "letter"),
            (False, 25, "a4"),
        ],
        2,
    ),
)
def test_pages_are_numbered_for_any_position_of_the_contents(
    project: Project, tmp_path: Path, finished: bool, line_count: int, page: Page
) -> None:
    if not finished:
        project = replace(project, result=None, validation=(), cross_checks=None, targets=())
    identity = EMPTY_IDENTITY.changed(remarks="\n".join(["word"] * line_count))
    content = sample_content(project.with_identity(identity))
    write_pdf(content, tmp_path / "r.pdf", {}, ReportOptions(page, extent="full"))
    text = _pdf_text(tmp_path / "r.pdf")
    numbers = [tuple(map(int, found)) for found in re.findall(r"Page (\d+) of (\d+)", text)]
    assert numbers == [(k + 1, len(numbers)) for k in range(len(numbers))]
    assert len(numbers) > 2
    assert text.count("Boresight calibration report") == len(numbers)  # title, then headers
    # The table of contents has the right page number.
    leaves = text.split("\f")
    (at,) = re.findall(r"Settings and input files[ .\u2060]+(\d+)", text)
    assert re.search(r"\d +Settings and input files\s*\n", leaves[int(at) - 1])


@pytest.mark.parametrize("key", [each.key for each in SYSTEMS if each.has_angles])
def test_angles_of_a_convention_convert_back_to_the_boresight(project: Project, key: str) -> None:
    found = _content(project, key).in_convention
    assert found is not None
    assert project.result is not None
    angles = np.radians([angle.value_deg for angle in found.angles])
    back = mounting_of_angles(
        ConventionSetup(convention_of_key(key)), angles, np.array(found.lever_arm_m)
    )
    np.testing.assert_allclose(
        back.rotation_body_lidar, project.result.mounting.rotation_body_lidar, atol=1e-12
    )
    np.testing.assert_allclose(back.lever_arm, LEVER_ARM, atol=1e-12)
    assert all(angle.sigma_deg for angle in found.angles)


def test_values_in_the_applanix_convention(project: Project) -> None:
    found = _content(project, "applanix").in_convention
    assert found is not None
    roll, pitch, heading = found.angles
    # For angles so small the two conventions differ by signs: X forward, Y starboard, Z down.
    assert roll.value_deg == pytest.approx(0.43951, abs=1e-9)
    assert pitch.value_deg == pytest.approx(1.86812, abs=1e-9)
    assert heading.value_deg == pytest.approx(0.39923, abs=1e-9)
    assert [a.sigma_deg for a in found.angles] == pytest.approx([0.0163, 0.0291, 0.0376])
    assert found.check_first is None


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize(
    "key", others_long(["applanix", "riprocess", "qinsy", "hypack", "pdal"], 2)
)
def test_report_has_values_and_their_uncertainty(
    project: Project, key: str, tmp_path: Path
) -> None:
    content = _content(project, key)
    found = content.in_convention
    assert found is not None
    write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
    pdf = re.sub(r"\s+", " ", _pdf_text(tmp_path / "r.pdf"))
    html = " ".join(_page(html_text(content, {}, FULL_REPORT)).words).replace("\u2212", "-")
    for text in (pdf, html):
        for angle in found.angles:
            assert f"{angle.value_deg:+.4f}" in text
            assert f"{angle.sigma_deg:.4f}" in text
        assert str(found.status_text) in text
        assert (message_text(CHECK_FIRST_NOTE) in text) == (found.status != "verified")
        assert found.assumption is None or str(found.assumption)[:40] in text
    assert bool(found.angles) == convention_of_key(key).has_angles


@LONG
def test_classical_model_warns_that_its_sigmas_are_too_small(tmp_path: Path) -> None:
    content = sample_content(
        sample_project(tmp_path / "t", model="independent"), convention="qinsy"
    )
    assert content.in_convention is not None
    assert content.in_convention.warning == UNCORRELATED_WARNING
    assert message_text(UNCORRELATED_WARNING) in "".join(
        _page(html_text(content, {}, FULL_REPORT)).words
    )


@LONG
def test_matrix_equals_that_of_the_boresight(project: Project, tmp_path: Path) -> None:
    content = sample_content(project)
    assert content.matrix is not None
    assert project.result is not None
    transform = np.array(content.matrix.transform)
    np.testing.assert_array_equal(content.matrix.rotation, transform[:3, :3])
    back = convert_from_system(
        ConventionSetup(convention_of_key("pdal")), transform[:3, :3], transform[:3, 3]
    )
    np.testing.assert_allclose(back.boresight, project.result.mounting.boresight, atol=1e-14)
    np.testing.assert_allclose(back.lever_arm, LEVER_ARM, atol=1e-15)
    # PDAL's body frame is forward, starboard, down, so Y and Z change sign.
    point = np.array([3.0, -20.0, 5.0])
    ours = project.result.mounting.rotation_body_lidar @ point + LEVER_ARM
    np.testing.assert_allclose((transform @ [*point, 1])[:3], ours * [1, -1, -1], atol=1e-12)
    write_tables(content, tmp_path / "r.zip")
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        (name,) = (n for n in archive.namelist() if "matrix-from-scanner" in n)
        head, *rows = csv.reader(archive.read(name).decode("utf-8-sig").splitlines())
    assert head == ["Scanner X", "Scanner Y", "Scanner Z", "Lever arm (m)"]
    np.testing.assert_allclose(np.array(rows, dtype=float), transform, atol=0.51e-10)


def test_values_are_not_reported_without_a_result(project: Project) -> None:
    content = _content(replace(project, result=None, validation=()), "applanix")
    assert content.in_convention is None
    assert content.matrix is None
    assert "Values for other programs" not in html_text(content, {}, FULL_REPORT)


def test_the_command_takes_page_convention_and_template(
    demo_project: Project, template: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def words(output: str, *more: object) -> list[str]:
        where = ["report", demo_project.folder, "--output", tmp_path / output]
        return [str(word) for word in (*where, *more)]

    assert main(words("r.html", "--template", template, "--page", "a4")) == 0
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert "size: A4;" in text
    assert "Order 4711" in text
    with pytest.raises(SystemExit):
        main(words("r.html", "--page", "a5"))
    capsys.readouterr()
    refused_with(
        "survey.unknown_program", *words("none.json", "--convention", "lidarsoft"), name="lidarsoft"
    )
    assert not (tmp_path / "none.json").exists()
    assert main(words("r.json", "--convention", "applanix")) == 0
    data = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    assert data["calibrated"] is False  # the demo before an adjustment
    assert data["in_convention"] is None


def test_a_logo_is_recognised_by_its_content(template: Path, tmp_path: Path) -> None:
    """A PNG is recognised by its first bytes, not by its name."""
    logo = tmp_path / "art" / "logo.png"
    logo.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(40))
    template.write_text(
        template.read_text(encoding="utf-8").replace("logo.svg", "logo.png"), "utf-8"
    )
    assert report_options(template).logo == logo
    logo.write_bytes(LOGO)
    with pytest.raises(InputError) as refusal:
        report_options(template)
    assert "report_template.logo_format" in codes_of(refusal.value)
    assert str(logo) in str(refusal.value)
