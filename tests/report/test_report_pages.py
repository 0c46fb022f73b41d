"""Tests of the pages of the PDF: number, filled height, and what stays together."""

import re
from collections.abc import Sequence
from dataclasses import replace
from io import BytesIO
from itertools import product
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text
from PIL import Image

from lispac.acceptance import NO_CRITERIA
from lispac.language import LANGUAGES, LazyText, in_language, without_advice
from lispac.message_texts import message_text
from lispac.messages import note, sort_by_importance, warning
from lispac.present.line_colours import LINE_COLOURS
from lispac.project import Project
from lispac.report import pdf
from lispac.report.content import ReportContent
from lispac.report.distance_maps import map_figure_of, map_row_figure_of
from lispac.report.document import undrawn_document
from lispac.report.document_blocks import (
    Bullets,
    Column,
    Document,
    Paragraph,
    Section,
    SignatureLines,
    Table,
)
from lispac.report.figures import (
    AFTER_COLOUR,
    BEFORE_COLOUR,
    MAX_SIGHTINGS_PER_FIGURE,
    residual_figures_of,
)
from lispac.report.html import html_text
from lispac.report.options import EXTENTS, PAGE_SIZES, Extent, Page, ReportOptions
from lispac.report.pdf import preview_of, write_pdf
from lispac.report.short_report import (
    MAX_NOTES,
    MAX_PICTURED_PLANES,
    MAX_PLANES,
)
from lispac.validation.comparison_results import LineShift
from tests.report.test_identity import FULL
from tests.report.test_report import _pdf_text
from tests.support.long_runs import LONG, others_long
from tests.support.report_sample import (
    FULL_REPORT,
    sample_content,
    sample_project,
    undrawn_pictures,
)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("pages") / "harbour")


def _document(lines: int) -> Document:
    """Return a document with a list and a section that begin after so many lines of a page."""
    above = Paragraph("\n".join(["above"] * lines))
    return Document(
        "Title", "project", "LISPAC", "now", "good", "CALIBRATED", Table("Details", (), (), ()),
        warnings=(), summary=(Paragraph("page one"),), conclusion=(), notes=(),
        sections=(
            Section("First", (above, Paragraph("Announced:"), Bullets(("item one", "item two")))),
            Section("Headed", (Paragraph("under its head"),)),
        ),
    )  # fmt: skip


@LONG
@pytest.mark.usefixtures("usual_gaps")
def test_headings_and_introductions_stay_with_what_follows(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, ends = sample_content(project), set()
    for lines in range(40, 60):
        monkeypatch.setattr(pdf, "report_document", lambda *_, lines=lines: _document(lines))
        write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
        pages = _pdf_text(tmp_path / "r.pdf").split("\f")
        (announced,) = (k for k, page in enumerate(pages) if "Announced:" in page)
        assert "item one" in pages[announced], lines
        (below,) = (k for k, page in enumerate(pages) if "under its head" in page)
        assert "2 Headed" in " ".join(pages[below].split()), lines
        ends.add((announced, below))
    assert ends >= {(1, 1), (1, 2), (2, 2)}  # page breaks occurred at both places


def test_smaller_gaps_avoid_a_last_page_of_a_few_lines(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, gaps = sample_content(project), pdf.SECTION_GAPS

    def pages(paragraphs: int) -> list[str]:
        below = tuple(Paragraph(f"paragraph {k}.") for k in range(paragraphs))
        document = replace(_document(1), sections=(Section("Section", below),))
        return _written_pages(content, tmp_path / "r.pdf", monkeypatch, document)

    monkeypatch.setattr(pdf, "SECTION_GAPS", (1.0,))
    usual = len(pages(30))
    first = next(count for count in range(30, 90) if len(pages(count)) > usual)
    monkeypatch.setattr(pdf, "SECTION_GAPS", gaps)
    shown = pages(first)
    assert len(shown) == usual
    assert f"paragraph {first - 1}." in shown[-2]  # after the last page is a form feed


def _table(title: str, rows: int) -> Table:
    cells = tuple((f"{title} row {k}", str(k)) for k in range(rows))
    return Table(title, (Column("Name", "left"), Column("Number")), cells, cells)


def _written_pages(
    content: ReportContent, path: Path, monkeypatch: pytest.MonkeyPatch, document: Document
) -> list[str]:
    monkeypatch.setattr(pdf, "report_document", lambda *_: document)
    write_pdf(content, path, {}, FULL_REPORT)
    return _pdf_text(path).split("\f")


@pytest.mark.usefixtures("usual_gaps")
def test_a_section_does_not_begin_without_its_table_and_a_short_list_is_not_divided(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, ends = sample_content(project), set()
    for lines in range(22, 54, 3):
        above = Paragraph("\n".join(["above"] * lines))
        introduction = (Paragraph("A first sentence."), Paragraph("A second sentence."))
        bullets = Bullets(tuple(f"item {k}" for k in range(6)))
        sections = (
            Section("Above", (above, bullets)),
            Section("Headed", (*introduction, _table("Cells", 9))),
        )  # fmt: skip
        document = replace(_document(1), sections=sections)
        pages = _written_pages(content, tmp_path / "r.pdf", monkeypatch, document)
        (headed,) = (k for k, page in enumerate(pages) if "A first sentence." in page)
        texts = ("2 Headed", "A second sentence.", "Cells row 0", "Cells row 8")
        assert all(text in " ".join(pages[headed].split()) for text in texts), lines
        (listed,) = (k for k, page in enumerate(pages) if "item 0" in page)
        assert "item 5" in pages[listed], lines
        ends.add((listed, headed))
    assert ends >= {(1, 1), (1, 2), (2, 2)}  # page breaks occurred at both places


@pytest.mark.usefixtures("usual_gaps")
def test_the_distance_between_tables_does_not_depend_on_their_lengths(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, distances = sample_content(project), []
    for rows in (14, 15):  # a table of more than 14 rows may be divided
        tables = (_table("Upper", 2), _table("Lower", rows))
        document = replace(_document(1), sections=(Section("Tables", tables),))
        _written_pages(content, tmp_path / "r.pdf", monkeypatch, document)
        boxes = _pdf_text(tmp_path / "r.pdf", "-bbox")
        upper, lower = (
            float(re.findall(rf'yMin="([0-9.]+)"[^>]*>{title}<', boxes)[0])
            for title in ("Upper", "Lower")
        )
        distances.append(lower - upper)
    assert distances[0] == pytest.approx(distances[1], abs=0.5)


@pytest.mark.usefixtures("usual_gaps")
def test_a_table_of_many_rows_is_on_one_page(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = sample_content(project)
    document = replace(_document(1), sections=(Section("Tables", (_table("Cells", 48),)),))
    pages = _written_pages(content, tmp_path / "r.pdf", monkeypatch, document)
    (begun,) = (k for k, page in enumerate(pages) if "Cells row 0" in page)
    assert "Cells row 47" in pages[begun]


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize("page", others_long(["a4", "letter"]))
@pytest.mark.parametrize("size", [(1400, 1000), (1000, 1000), (500, 900)])
def test_pictures_before_and_after_are_on_one_page(
    project: Project, tmp_path: Path, page: Literal["a4", "letter"], size: tuple[int, int]
) -> None:
    pictures = {}
    for name in ("before", "after"):
        figure = Figure((size[0] / 100, size[1] / 100), dpi=100)
        figure.savefig(tmp_path / f"{name}.png")
        pictures[f"The lines {name}"] = tmp_path / f"{name}.png"
    options = ReportOptions(page=page)
    write_pdf(sample_content(project), tmp_path / "r.pdf", pictures, options)
    pages = _pdf_text(tmp_path / "r.pdf").split("\f")
    (shown,) = (text for text in pages if "The lines before" in text)
    assert "The lines after" in shown
    assert "Pictures" in shown


VIEWS = ["Overview", *(f"V{k}" for k in range(1, 6))]
"""Views of which the window takes pictures before and after for the short report."""
TEXT_HEIGHTS_MM = {"a4": 250.0, "letter": 232.4}
"""Heights of the text on a page."""
TOP_MM, PPI = 25.0, 40.0


def _survey_content(project: Project, planes: int = 5) -> ReportContent:
    """Return a content as of a common survey, with all details and an acceptance."""
    criteria = NO_CRITERIA.changed(rms=0.05, roll_sigma_deg=0.05, source="Contract C-77")
    content = sample_content(
        replace(project, identity=FULL, acceptance=criteria), convention="qinsy"
    )
    plane = content.validation[0]
    names = [f"V{k}" for k in range(1, planes + 1)]
    section = content.plane_sections[0]
    return replace(
        content,
        validation=tuple(replace(plane, name=name) for name in names),
        plane_sections=tuple(replace(section, plane=name) for name in names),
    )


@pytest.fixture(scope="module")
def views(tmp_path_factory: pytest.TempPathFactory) -> dict[str | LazyText, Path]:
    folder = tmp_path_factory.mktemp("views")
    figure = Figure((10, 7), dpi=20, facecolor="0.8")
    figure.savefig(folder / "view.png")
    return {f"{name} {when}": folder / "view.png" for name in VIEWS for when in ("before", "after")}


def _filled_shares(pages: Sequence[bytes], page: Page) -> list[float]:
    """Return the share of the text height of each page that is filled."""
    shares = []
    for data in pages:
        grey = np.asarray(Image.open(BytesIO(data)).convert("L"))
        first = round(TOP_MM / 25.4 * PPI)
        height = TEXT_HEIGHTS_MM[page] / 25.4 * PPI
        rows = np.flatnonzero((grey[first : round(first + height)] < 245).any(axis=1))
        shares.append((rows[-1] + 1) / height)
    return shares


@pytest.mark.parametrize("has_views", others_long([True, False]))
@pytest.mark.parametrize("language", others_long(LANGUAGES, lambda language: language == "fr"))
@pytest.mark.parametrize("page", others_long(PAGE_SIZES))
def test_the_short_report_has_at_most_four_well_filled_pages(
    project: Project, views: dict[str | LazyText, Path], page: Page, language: str, has_views: bool
) -> None:
    options = ReportOptions(page, language=language)
    content = _survey_content(project)
    made = preview_of(content, views if has_views else {}, options, ppi=PPI)
    assert 2 <= len(made.pages) <= 4
    assert min(_filled_shares(made.pages[:-1], page)) >= 0.5


VERDICT_CRITERIA = {
    "fail": NO_CRITERIA.changed(
        rms=1e-3, p95=1e-3, offset=1e-4, roll_sigma_deg=1e-3, source="Contract C-77"
    ),
    "pass": NO_CRITERIA.changed(rms=9.0, roll_sigma_deg=9.0, source="Contract C-77"),
    "not judged": NO_CRITERIA,
    "not validated": NO_CRITERIA,
}
"""Acceptance criteria with which a survey gets each verdict."""
COMPLETE_CASES = [
    # verdict, planes, warnings, notes, views, tall surfaces, language, page, convention
    ("fail", 5, 15, 6, True, False, "en", "a4", ""),
    ("fail", 12, 1, 4, True, True, "fr", "letter", "qinsy"),
    ("fail", 5, 1, 6, True, True, "fr", "a4", "qinsy"),
    ("fail", 5, 6, 0, False, True, "en", "letter", "qinsy"),
    ("fail", 40, 6, 2, False, False, "fr", "letter", "qinsy"),
    ("fail", 1, 1, 2, True, False, "en", "a4", "qinsy"),
    ("pass", 2, 16, 8, True, True, "fr", "letter", "qinsy"),
    ("pass", 40, 1, 2, True, False, "fr", "letter", "qinsy"),
    ("not judged", 5, 1, 6, True, True, "en", "a4", "qinsy"),
    ("not judged", 2, 0, 2, False, True, "fr", "a4", "qinsy"),
    ("not validated", 3, 1, 8, True, False, "en", "a4", "qinsy"),
    ("not validated", 3, 0, 2, False, False, "fr", "letter", "qinsy"),
]


@pytest.mark.usefixtures("rectangles")
@pytest.mark.parametrize(
    (
        "verdict",
        "planes",
        "warnings",
        "notes",
        "has_views",
        "is_tall",
        "language",
        "page",
        "convention",
    ),
    others_long(COMPLETE_CASES, lambda case: case in COMPLETE_CASES[:2]),
)
def test_the_short_report_of_each_verdict_has_at_most_four_well_filled_pages(
    project: Project,
    views: dict[str | LazyText, Path],
    tmp_path: Path,
    verdict: str,
    planes: int,
    warnings: int,
    notes: int,
    has_views: bool,
    is_tall: bool,
    language: str,
    page: Page,
    convention: str,
) -> None:
    """The figures of each plane are on one page, and each heading is above its content."""
    plane = project.validation[0]
    if is_tall:
        maps = tuple(replace(each, across=each.up, up=2 * each.across) for each in plane.maps)
        plane = replace(plane, maps=maps)
    names = [] if verdict == "not validated" else [f"V{k}" for k in range(1, planes + 1)]
    judged = replace(
        project,
        identity=FULL,
        validation=tuple(replace(plane, name=name) for name in names),
        acceptance=VERDICT_CRITERIA[verdict],
    )
    messages = (
        *(warning("report.file_missing", files=(f"L{k}.las",)) for k in range(warnings)),
        *(note("report.not_compared", reason=f"{k} {LONG_REASON[:100]}") for k in range(notes)),
    )
    content = replace(sample_content(judged, convention=convention), warnings=messages)
    expected = verdict if verdict in ("fail", "pass") else "not judged"
    assert content.acceptance.verdict == expected
    pictured = ("Overview", *names[:MAX_PICTURED_PLANES])
    pictures = {
        caption: file
        for caption, file in views.items()
        if has_views and str(caption).split()[0] in pictured
    }
    made = preview_of(content, pictures, ReportOptions(page, language=language), ppi=PPI)
    assert 2 <= len(made.pages) <= 4
    assert min(_filled_shares(made.pages[:-1], page)) >= 0.5
    (tmp_path / "r.pdf").write_bytes(made.pdf)
    texts = _pdf_text(tmp_path / "r.pdf").split("\f")[: len(made.pages)]
    for name in names:
        caption = rf"(?:^ *| {{2,}}){name}\s?: (?!L\d|values of)|\b{name} before\b"
        assert sum(bool(re.search(caption, text, re.MULTILINE)) for text in texts) <= 1, name
    with in_language(language):
        titles = [section.title for section in undrawn_document(content, pictures).sections]
    for title in titles:
        (below,) = (
            lines[lines.index(title) + 1 :]
            for lines in ([line.strip() for line in text.splitlines()] for text in texts)
            if title in lines
        )
        assert sum(bool(line) for line in below) > 1, title  # more than the footer


@LONG
@pytest.mark.parametrize(
    ("language", "page"),
    others_long([("en", "a4"), ("fr", "letter"), ("en", "letter"), ("fr", "a4")]),
)
def test_the_full_report_has_well_filled_pages_with_their_numbers(
    project: Project,
    views: dict[str | LazyText, Path],
    tmp_path: Path,
    page: Page,
    language: str,
) -> None:
    options = ReportOptions(page, language=language, extent="full")
    made = preview_of(_survey_content(project), views, options, ppi=PPI)
    assert min(_filled_shares(made.pages[:-1], page)) >= 0.5
    (tmp_path / "r.pdf").write_bytes(made.pdf)
    pages = _pdf_text(tmp_path / "r.pdf").split("\f")[: len(made.pages)]
    for number, text in enumerate(pages, 1):
        assert re.findall(r"\bPage (\d+) \w+ (\d+)", text) == [(str(number), str(len(pages)))]
    contents = re.findall(r"^ *(\d+) +(\S.*?)[ .]{4,}\u2060?(\d+)$", pages[1], re.MULTILINE)
    assert len(contents) > 8
    for section, title, number in contents:
        assert f"{section} {title}" in " ".join(pages[int(number) - 1].split())


@pytest.mark.usefixtures("rectangles")
@pytest.mark.parametrize("planes", others_long([5, 2, 3, 4, 6]))
@pytest.mark.parametrize("language", others_long(LANGUAGES, lambda language: language == "fr"))
@pytest.mark.parametrize(
    ("extent", "page"),
    others_long(
        product(EXTENTS, PAGE_SIZES), lambda case: case in (("short", "a4"), ("full", "letter"))
    ),
)
def test_the_figures_of_a_validation_plane_are_on_one_page(
    project: Project,
    views: dict[str | LazyText, Path],
    tmp_path: Path,
    extent: Extent,
    page: Page,
    language: str,
    planes: int,
) -> None:
    """No page is less than half full for that."""
    content = _survey_content(project, planes)
    names = [f"V{k}" for k in range(1, planes + 1)]
    shown = {
        each: file for each, file in views.items() if str(each).split()[0] in ("Overview", *names)
    }
    for pictures in (shown, {}):
        options = ReportOptions(page, language=language, extent=extent)
        made = preview_of(content, pictures, options, ppi=PPI)
        assert min(_filled_shares(made.pages, page)) >= 0.5
        (tmp_path / "r.pdf").write_bytes(made.pdf)
        pages = _pdf_text(tmp_path / "r.pdf").split("\f")
        for name in names:
            # Captions begin with the name, in the first column or in another one.
            caption = rf"(?:^ *| {{2,}}){name}\s?: "
            if extent == "short":  # the views of a full report are in a section of their own
                caption = rf"{caption}|\b{name} before\b"
            captioned = [
                k for k, text in enumerate(pages) if re.search(caption, text, re.MULTILINE)
            ]
            assert len(captioned) <= 1, (name, bool(pictures))
            assert captioned or extent == "short"


@LONG
@pytest.mark.parametrize("page", others_long(PAGE_SIZES))
def test_a_long_introduction_leaves_no_page_less_than_half_full(
    project: Project, monkeypatch: pytest.MonkeyPatch, page: Page
) -> None:
    content = sample_content(project)
    introduction = (Paragraph("A sentence."),) * 17
    for lines in range(12, 44, 6):
        sections = (
            Section("Above", (Paragraph("above"),) * lines),
            Section("Headed", (*introduction, _table("Cells", 9), *introduction, *introduction)),
        )
        document = replace(_document(1), sections=sections, page=page)
        monkeypatch.setattr(pdf, "report_document", lambda *_, document=document: document)
        made = preview_of(content, {}, replace(FULL_REPORT, page=page), ppi=PPI)
        assert len(made.pages) >= 3
        assert min(_filled_shares(made.pages[1:-1], page)) >= 0.5, lines


@LONG
@pytest.mark.usefixtures("rectangles")
@pytest.mark.parametrize("planes", others_long([4, 2, 3, 5, 6]))
@pytest.mark.parametrize("page", others_long(PAGE_SIZES))
@pytest.mark.parametrize("first", others_long([0, 6]))
def test_figures_of_planes_leave_no_page_less_than_half_full_wherever_they_begin(
    project: Project, monkeypatch: pytest.MonkeyPatch, page: Page, planes: int, first: int
) -> None:
    content = _survey_content(project, planes)
    options = replace(FULL_REPORT, page=page)
    document = pdf.report_document(content, {}, options)
    for lines in range(first, 36, 12):
        sections = tuple(
            replace(section, blocks=(*(Paragraph("above"),) * lines, *section.blocks))
            if section.title == "Validation"
            else section
            for section in document.sections
        )
        assert lines == 0 or sections != document.sections
        moved = replace(document, sections=sections)
        monkeypatch.setattr(pdf, "report_document", lambda *_, moved=moved: moved)
        made = preview_of(content, {}, options, ppi=PPI)
        assert min(_filled_shares(made.pages, page)) >= 0.5, lines


@LONG
@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_figures_of_planes_do_not_overlap_the_list_above_them(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, below_list = _survey_content(project, 6), 0
    document = pdf.report_document(content, {}, FULL_REPORT)
    (validation,) = (each for each in document.sections if each.title == "Validation")
    for lines in (0, 8, 16, 24):
        blocks = (*(Paragraph("above"),) * lines, *validation.blocks)
        moved = replace(document, sections=(replace(validation, blocks=blocks),))
        monkeypatch.setattr(pdf, "report_document", lambda *_, moved=moved: moved)
        write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
        words = re.findall(
            r'yMin="([0-9.]+)" xMax="[0-9.]+" yMax="([0-9.]+)">([^<]*)<',
            _pdf_text(tmp_path / "r.pdf", "-bbox"),
        )
        (first,) = (k for k, (*_, word) in enumerate(words) if word == "Maps:")
        (_, above, line), (top, _, _) = words[first - 1], words[first]
        if line.startswith("L"):  # the last pair of lines that was not compared, on the same page
            below_list += 1
            assert float(top) > float(above)
    assert below_list


@pytest.mark.usefixtures("rectangles")
def test_the_short_report_names_the_colours_of_the_lines(
    project: Project, views: dict[str | LazyText, Path]
) -> None:
    """Also the full one, where there are pictures with lines."""
    content = _survey_content(project)
    names = [line.name for line in content.lines]
    for extent, pictures in product(EXTENTS, (views, {})):
        options = ReportOptions(extent=extent)
        document = undrawn_document(content, pictures, options)
        legends = [
            block.colours
            for section in document.sections
            for block in section.blocks
            if isinstance(block, Paragraph) and block.colours
        ]
        assert len(legends) == bool(pictures)
        for legend in legends:
            assert [name for name, _ in legend] == names
            assert [colour for _, colour in legend] == [
                f"#{red:02x}{green:02x}{blue:02x}"
                for red, green, blue in LINE_COLOURS[: len(names)]
            ]
        text = html_text(content, pictures, options)
        assert ('class="swatch"' in text) == bool(pictures)


@LONG
@pytest.mark.usefixtures("rectangles")
def test_a_short_report_of_a_large_survey_is_short_and_has_all_warnings(project: Project) -> None:
    content = _survey_content(project, planes=40)
    warnings = tuple(warning("report.file_missing", files=(f"L{k}.las",)) for k in range(6))
    notes = tuple(note("report.not_compared", reason=f"reason {k}") for k in range(40))
    cause = note("acceptance.cause_geometry", angles=("yaw",))
    ordered = sort_by_importance((*warnings, *notes, cause))
    content = replace(content, warnings=ordered)
    document = undrawn_document(content, {})
    with without_advice():
        assert document.notes[0] == message_text(cause)
    assert len(document.warnings) == len(warnings)
    assert len(document.notes) == MAX_NOTES
    tables = [block for block in document.summary if isinstance(block, Table)]
    (distances,) = (table for table in tables if len(table.rows) > 10)
    assert len(distances.rows) == MAX_PLANES
    figures = list(undrawn_pictures(b for s in document.sections for b in s.blocks))
    # Site plan, histograms and maps, and a single section beside the table of many planes
    assert len(figures) == 2 + MAX_PICTURED_PLANES + 1
    made = preview_of(content, {}, ReportOptions("letter"), ppi=PPI)
    assert len(made.pages) <= 4


@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_the_short_report_is_signed_below_the_verdict_and_has_the_system(
    project: Project, tmp_path: Path
) -> None:
    content = _survey_content(project)
    document = undrawn_document(content, {})
    assert isinstance(document.conclusion[-1], SignatureLines)
    ends = {row[-1] for b in document.summary if isinstance(b, Table) for row in b.rows}
    assert ends & {"pass", "fail"}  # the verdicts are above the signatures
    tables = [b for s in document.sections for b in s.blocks if isinstance(b, Table)]
    (system,) = (b for b in tables if any(row[0] == "INS/GNSS" for row in b.rows))
    names = {row[0] for table in tables for row in table.rows}
    assert {
        "Lines used",
        "Chi-square test at 95 %",
        "Cross-checks",
        "LiDAR noise, 1 sigma",
    } <= names
    assert {target.target for target in content.adjustment.targets} <= names
    facts = dict(system.rows)
    assert FULL.scanner in facts["Scanner"]
    assert FULL.scanner_serial in facts["Scanner"]
    assert FULL.pos in facts["INS/GNSS"]
    (lever_arm,) = (text for name, text in system.rows if name.endswith("(forward, left, up)"))
    lever_arm = lever_arm.replace("\u2212", "-")
    numbers = [float(number) for number in re.findall(r"-?[\d.]+", lever_arm)]
    assert numbers == list(content.settings.lever_arm_m)
    write_pdf(content, tmp_path / "r.pdf", {}, ReportOptions())
    pages = _pdf_text(tmp_path / "r.pdf").split("\f")
    order = [pages[0].index(text) for text in ("Yaw", "Validation:", "Place and date", "Notes")]
    assert order == sorted(order)


SIGNED_TEXTS = {
    "en": ("Estimated", "Acceptance criteria (", "Place and date", "Signature", "ACCEPT"),
    "fr": ("Estimé", "Critères d’acceptation (", "Lieu et date", "Signature", "CRITÈRES D’ACCEPT"),
}
"""Texts of the angles, the acceptance, the lines to sign and the verdict."""
LONG_REASON = " ".join(["reason"] * 40)


def _signed_page(content: ReportContent, path: Path, options: ReportOptions) -> int:
    """Return the number of the only page with the angles, the verdict and the lines to sign."""
    write_pdf(content, path, {}, options)
    pages = _pdf_text(path).split("\f")
    *signed, verdict = SIGNED_TEXTS[options.language]
    (number,) = {k for k, page in enumerate(pages, 1) if any(text in page for text in signed)}
    assert all(text in pages[number - 1] for text in (*signed, verdict))
    return number


@LONG
@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize("warnings", others_long([3, 0]))
@pytest.mark.parametrize("notes", others_long([8, 1, 2, 3, 4, 5, 6, 7]))
@pytest.mark.parametrize(
    ("language", "page"),
    others_long([("fr", "a4"), ("en", "letter"), ("en", "a4"), ("fr", "letter")]),
)
def test_the_short_report_is_signed_on_page_one_below_the_angles(
    project: Project, tmp_path: Path, page: Page, language: str, notes: int, warnings: int
) -> None:
    messages = (
        *(warning("report.file_missing", files=(f"L{k}.las",)) for k in range(warnings)),
        *(note("report.not_compared", reason=f"{k} {LONG_REASON}") for k in range(notes)),
    )
    content = replace(_survey_content(project), warnings=messages)
    options = ReportOptions(page, language=language)
    assert _signed_page(content, tmp_path / "r.pdf", options) == 1


@LONG
@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize("page", others_long(PAGE_SIZES))
@pytest.mark.parametrize("planes", others_long([40, 5, 12]))
def test_after_many_warnings_the_signatures_are_with_the_angles_and_the_verdict(
    project: Project, tmp_path: Path, page: Page, planes: int
) -> None:
    plane = project.validation[0]
    first, *others = dict.fromkeys(
        line for pair in plane.pairs for line in (pair.line_a, pair.line_b)
    )
    shift = LineShift((first,), tuple(others), 0.1, 0.001)
    failed = replace(
        project,
        identity=FULL,
        validation=tuple(
            replace(plane, name=f"V{k}", shifts=(shift,)) for k in range(1, planes + 1)
        ),
        acceptance=NO_CRITERIA.changed(
            rms=1e-3, p95=1e-3, offset=1e-4, roll_sigma_deg=1e-3, source="Contract C-77"
        ),
    )
    content = sample_content(failed, convention="qinsy")
    total = sum(check.verdict == "fail" for check in content.acceptance.checks)
    assert total == 3 * planes + 1
    document = undrawn_document(content, {}, ReportOptions(page))
    assert len(document.warnings) > planes, "a shifted line on each plane"
    (table,) = (
        block
        for block in document.summary
        if isinstance(block, Table) and block.title.startswith("Acceptance")
    )
    assert len(table.rows) == 4
    assert _signed_page(content, tmp_path / "r.pdf", ReportOptions(page)) > 1


def test_the_report_has_no_columns_on_spheres_without_spheres(project: Project) -> None:
    content = _survey_content(project)
    assert all(plane.shape == "plane" for plane in content.planes)

    def titles(shown: ReportContent) -> set[str]:
        document = undrawn_document(shown, {}, ReportOptions(extent="full"))
        tables = [b for s in document.sections for b in s.blocks if isinstance(b, Table)]
        return {column.title for table in tables for column in table.columns}

    assert "Shape" not in titles(content)
    ball = replace(content.planes[0], shape="sphere")
    assert "Shape" in titles(replace(content, planes=(ball, *content.planes[1:])))


@LONG
@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_degrees_are_written_in_one_way_in_print(project: Project, tmp_path: Path) -> None:
    for extent in EXTENTS:
        write_pdf(_survey_content(project), tmp_path / "r.pdf", {}, ReportOptions(extent=extent))
        text = _pdf_text(tmp_path / "r.pdf")
        assert "°" in text
        assert not re.search(r"\bdeg\b", text)


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize("extent", others_long(EXTENTS, lambda extent: extent == "short"))
def test_lines_of_a_note_are_nearer_to_each_other_than_to_the_next_note(
    project: Project, tmp_path: Path, extent: Extent
) -> None:
    content = _survey_content(project)
    words = ("alpha", "beta")
    notes = tuple(note("report.not_compared", reason=" ".join([word] * 40)) for word in words)
    write_pdf(
        replace(content, warnings=notes), tmp_path / "r.pdf", {}, ReportOptions(extent=extent)
    )
    boxes = _pdf_text(tmp_path / "r.pdf", "-bbox")
    first, second = (
        sorted({float(y) for y in re.findall(rf'yMin="([0-9.]+)"[^>]*>{word}<', boxes)})
        for word in words
    )
    assert min(len(first), len(second)) >= 2
    assert second[0] - first[-1] > 1.05 * max(*np.diff(first), *np.diff(second))


def test_the_pairs_with_the_largest_distances_are_mapped_in_a_short_report(
    project: Project,
) -> None:
    content = _survey_content(project)
    plane = next(plane for plane in content.validation if plane.maps)
    maps = tuple(
        replace(plane.maps[0], line_b=f"L{k}", after_m=tuple(k * d for d in plane.maps[0].after_m))
        for k in (3, 1, 2)
    )
    figure = map_row_figure_of(replace(plane, maps=maps))
    text = " ".join(each.get_text() for each in figure.findobj(Text))
    assert "L3" in text
    assert "L2" in text
    assert "L1" not in text.replace(plane.maps[0].line_a, "")


def test_the_full_report_is_signed_below_the_acceptance_and_explains_the_angles_once(
    project: Project,
) -> None:
    document = undrawn_document(_survey_content(project), {}, FULL_REPORT)
    last = document.summary[-1]
    assert isinstance(last, Table)
    assert last.title.startswith("Acceptance criteria")
    first = document.sections[0]
    explained = [b.text for b in first.blocks if isinstance(b, Paragraph) and "Rz(" in b.text]
    assert len(explained) == 1


def test_the_figures_of_a_target_are_not_divided(project: Project) -> None:
    adjustment = sample_content(project).adjustment
    assert adjustment is not None
    each = adjustment.sightings[0]
    named = [
        replace(each, target=target, line=f"L{k}")
        for target, count in (("T1", 8), ("T2", 8), ("T3", 8), ("T4", 6))
        for k in range(count)
    ]
    heights = [figure.axes[0].get_yticklabels() for figure in residual_figures_of(named)]
    targets = [{label.get_text().split()[0] for label in labels} for labels in heights]
    assert targets == [{"T1", "T2"}, {"T3", "T4"}]
    # A target with more sightings than a figure has space for is divided.
    many = [replace(each, line=f"L{k}") for k in range(MAX_SIGHTINGS_PER_FIGURE + 1)]
    assert len(residual_figures_of(many)) == 2


def test_before_and_after_differ_in_a_print_without_colours() -> None:
    def luminance(colour: str) -> float:
        red, green, blue = to_rgb(colour)
        return 0.299 * red + 0.587 * green + 0.114 * blue

    assert luminance(BEFORE_COLOUR) - luminance(AFTER_COLOUR) > 0.2


def test_the_caption_of_each_map_explains_its_colours(project: Project) -> None:
    document = undrawn_document(_survey_content(project), {}, FULL_REPORT)
    figures = undrawn_pictures(block for s in document.sections for block in s.blocks)
    maps = [figure.caption for figure in figures if figure.draw is map_figure_of]
    assert len(maps) == 5
    assert all("Red: the first line is nearer to the vessel" in caption for caption in maps)


def test_a_company_in_the_letterhead_is_not_asked_for_again(project: Project) -> None:
    for company in ("", "Levés du Fleuve inc."):
        document = undrawn_document(
            sample_content(project), {}, replace(FULL_REPORT, company=company)
        )
        assert ("Company" in dict(document.identity.rows)) == (not company)


@pytest.mark.usefixtures("rectangles", "usual_gaps")
@pytest.mark.parametrize("language", LANGUAGES)
def test_the_date_is_in_one_line_beside_a_short_or_below_a_long_title(
    project: Project, tmp_path: Path, language: str
) -> None:
    write_pdf(sample_content(project), tmp_path / "r.pdf", {}, ReportOptions(language=language))
    first = _pdf_text(tmp_path / "r.pdf", "-layout", "-f", "1", "-l", "1")
    assert re.search(r"(Created|Établi le) 2025-06-04 14:03 UTC", first)
