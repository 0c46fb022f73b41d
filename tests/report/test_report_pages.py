"""Tests of page breaks in the PDF: headings and introductions stay with what follows."""

from pathlib import Path
from typing import Literal

import pytest
from matplotlib.figure import Figure

from lispac.project import Project
from lispac.report import pdf
from lispac.report.document_blocks import Bullets, Document, Paragraph, Section, Table
from lispac.report.options import ReportOptions
from lispac.report.pdf import write_pdf
from tests.report.test_report import _pdf_text
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("pages") / "harbour")


def _document(lines: int) -> Document:
    """Return a document with a list and a section that begin after so many lines of a page."""
    above = Paragraph("\n".join(["above"] * lines))
    return Document(
        "Title", "project", "LISPAC", "now", "good", "CALIBRATED", Table("Details", (), (), ()), (),
        (),
        summary=(Paragraph("page one"),),
        sections=(
            Section("First", (above, Paragraph("Announced:"), Bullets(("item one", "item two")))),
            Section("Headed", (Paragraph("under its head"),)),
        ),
    )  # fmt: skip


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


@pytest.mark.parametrize("page", ["a4", "letter"])
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
