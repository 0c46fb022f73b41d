"""Tests that equal inputs give equal bytes in another process, folder and hash order."""

import hashlib
import os
import re
import shutil
import subprocess
import sys
from datetime import timedelta
from pathlib import Path

import pytest

from lispac.project import Project
from lispac.report.html import write_html
from lispac.report.json_report import write_json
from lispac.report.pdf import write_pdf
from lispac.workflow.output.export import write_report
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.report.test_report import _pdf_text
from tests.support.long_runs import others_long
from tests.support.report_sample import FULL_REPORT, MADE, sample_content, sample_project

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import sys
from dataclasses import replace
from pathlib import Path
from lispac.report.html import write_html
from lispac.report.json_report import write_json
from lispac.report.html import write_html
from lispac.report.json_report import write_json
from lispac.report.pdf import write_pdf
from lispac.report.csv_tables import write_tables
from lispac.workflow.output.report_options import report_options
from tests.support.report_sample import sample_content, sample_project
from tests.report.test_identity import FULL

folder = Path(sys.argv[1])
project = sample_project(folder / "harbour").with_identity(FULL)
(folder / "logo.svg").write_bytes(b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>')
(folder / "own.toml").write_text('logo = "logo.svg"\\ncompany = "Fleuve"\\nconvention = "qinsy"')
for page in ("a4", "letter"):
    options = report_options(folder / "own.toml", page)
    content = sample_content(project, convention=options.convention)
    write_pdf(content, folder / f"{page}.pdf", {}, options)
    write_html(content, folder / f"{page}.html", {}, options)
write_json(content, folder / "r.json")
write_tables(content, folder / "r.zip")
"""
FILE_NAMES = ("a4.pdf", "letter.pdf", "a4.html", "letter.html", "r.json", "r.zip")


def _digests(folder: Path, names: tuple[str, ...]) -> dict[str, str]:
    return {name: hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in names}


@pytest.mark.long
def test_two_processes_in_two_folders_write_the_same_bytes(tmp_path: Path) -> None:
    found = []
    for folder, seed in ((tmp_path / "one", "1"), (tmp_path / "elsewhere" / "two", "2")):
        folder.mkdir(parents=True)
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
        subprocess.run(
            [sys.executable, "-c", SCRIPT, str(folder)], check=True, env=environment, cwd=folder,
            timeout=300,
        )  # fmt: skip
        found.append(_digests(folder, FILE_NAMES))
    assert found[0] == found[1]
    assert len(set(found[0].values())) == len(FILE_NAMES)  # the page size changes the file


def test_another_date_changes_only_lines_with_the_date(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    texts, others = [], []
    for made in (MADE, MADE + timedelta(days=3)):
        content = sample_content(project, made)
        write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
        write_json(content, tmp_path / "r.json")
        write_html(content, tmp_path / "r.html", {}, FULL_REPORT)
        texts.append(_pdf_text(tmp_path / "r.pdf").splitlines())
        others.append([(tmp_path / name).read_bytes() for name in ("r.json", "r.html")])
    for early, late in zip(*others, strict=True):
        lines = zip(early.splitlines(), late.splitlines(), strict=True)
        assert sum(a != b for a, b in lines) == 1
    differing = [pair for pair in zip(*texts, strict=True) if pair[0] != pair[1]]
    assert differing
    for early, late in differing:
        assert re.sub("2025-06-04", "2025-06-07", early) == late


@pytest.mark.parametrize("kind", others_long(["json", "html"], lambda kind: kind == "html"))
def test_a_survey_in_two_folders_makes_the_same_report(
    demo_project: Project, tmp_path: Path, kind: str
) -> None:
    for place in ("here", "there"):
        folder = tmp_path / place / "quay"
        shutil.copytree(demo_project.folder, folder)
        project = open_project(folder)
        survey = load_survey(project)
        write_report(project, survey, tmp_path / f"{place}.{kind}", generated=MADE)
    here, there = ((tmp_path / f"{place}.{kind}").read_bytes() for place in ("here", "there"))
    assert here == there
    assert str(tmp_path).encode() not in here
