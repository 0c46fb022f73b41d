"""Where the pages of the PDF end: nothing that announces something is left behind."""

from pathlib import Path

import pytest

from lispac.project import Project
from lispac.report import pdf
from lispac.report.blocks import Bullets, Document, Paragraph, Section, Table
from lispac.report.pdf import write_pdf
from tests.report_sample import sample_content, sample_project
from tests.test_report import _pdf_text


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("pages") / "harbour")


def _document(lines: int) -> Document:
    """A list with its head, and a section, after so many lines on a page of their own."""
    above = Paragraph("\n".join(["above"] * lines))
    return Document(
        "Title", "project", "LISPAC", "now", "good", "CALIBRATED", Table("Details", (), ()), (), (),
        summary=(Paragraph("page one"),),
        sections=(
            Section("First", (above, Paragraph("Announced:"), Bullets(("item one", "item two")))),
            Section("Headed", (Paragraph("under its head"),)),
        ),
    )  # fmt: skip


def test_what_announces_something_stays_with_it(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content, ends = sample_content(project), set()
    for lines in range(40, 60):
        monkeypatch.setattr(pdf, "document_of", lambda *_, lines=lines: _document(lines))
        write_pdf(content, tmp_path / "r.pdf", {})
        pages = _pdf_text(tmp_path / "r.pdf").split("\f")
        (announced,) = (k for k, page in enumerate(pages) if "Announced:" in page)
        assert "item one" in pages[announced], lines
        (below,) = (k for k, page in enumerate(pages) if "under its head" in page)
        assert "2 Headed" in " ".join(pages[below].split()), lines
        ends.add((announced, below))
    assert ends >= {(1, 1), (1, 2), (2, 2)}  # the ends of the page were met
