"""Tests of French reports of every kind: only names remain as typed."""

import csv
import hashlib
import json
import pickle
import re
import zipfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, replace
from itertools import product
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from lispac.adjustment.diagnostics.error_budget import error_budget
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.alternative_methods import ALTERNATIVE_METHODS, AlternativeResult
from lispac.language import in_language
from lispac.messages import error, note
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.parameters import PARAMETERS_TABLE, ParameterValues
from lispac.present.survey.survey_data import LINES_TABLE, LineValues
from lispac.present.tables import Fact
from lispac.present.text_format import with_minus_signs
from lispac.project import Project
from lispac.report import figures
from lispac.report.content import ReportContent, report_content
from lispac.report.csv_tables import table_csv_text, write_tables
from lispac.report.document import drawn_document, report_document, undrawn_document
from lispac.report.document_blocks import (
    Bullets,
    Paragraph,
    SignatureLines,
    Table,
    facts_table,
    report_table,
)
from lispac.report.html import html_text
from lispac.report.options import Extent, ReportOptions
from lispac.report.pdf import write_pdf
from lispac.survey.conventions.systems import SYSTEMS
from lispac.survey.georeferencing import LEVER_ARM_NAMES
from lispac.targets.occlusion import ObservedExtent
from lispac.targets.sighting_quality import SightingQuality
from lispac.validation.absolute_check import (
    ALL_LINES,
    AbsoluteCheck,
    AbsoluteState,
    LineCheck,
    OtherSurface,
    PointCheck,
    SigmaSources,
)
from lispac.validation.comparison_results import DistanceStatistics, SignedStatistics
from tests.present.test_consistent_warnings import CASES
from tests.report.test_error_budget import system
from tests.report.test_report import _pdf_text
from tests.support.long_runs import LONG, others_long
from tests.support.report_sample import FULL_REPORT, MADE, sample_project, undrawn_pictures
from tests.support.report_variants import VARIANTS, content_of_sample, with_result, with_settings
from tests.targets.test_quality import board, quality_of

FRENCH = ReportOptions(language="fr", extent="full")


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("french") / "harbour 2025")


FIGURE_COUNTS: dict[bytes, int] = {}
"""Number of figures that a function draws from some values, by the digest of both."""


def _empty_pictures(
    draw: Callable[..., Figure | Sequence[Figure]], *values: object
) -> tuple[bytes, ...]:
    """An empty picture for each figure; drawing takes most of the time of a report."""
    key = hashlib.sha256(pickle.dumps((draw, values))).digest()
    if key not in FIGURE_COUNTS:
        made = draw(*values)
        FIGURE_COUNTS[key] = 1 if isinstance(made, Figure) else len(made)
    return (b"",) * FIGURE_COUNTS[key]


@pytest.fixture
def without_figures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(figures, "svg_pictures", _empty_pictures)


def _english_texts(content: ReportContent) -> tuple[str, ...]:
    """Return the texts of the French report that contain English words."""
    extents: tuple[Extent, ...] = ("short", "full")
    options = [ReportOptions(language="fr", extent=extent) for extent in extents]
    with in_language("fr"), pytest.MonkeyPatch.context() as patch:
        patch.setattr(figures, "svg_pictures", _empty_pictures)
        made = [asdict(drawn_document(undrawn_document(content, {}, each))) for each in options]
    english = re.compile(r"\b(the|of|and|or|to|is|was|were|are|with|from|by|its|they)\b")
    texts = json.dumps(made, default=lambda _: "", ensure_ascii=False).split('"')
    return tuple(text for text in texts if english.search(text))


@pytest.mark.parametrize("variant", VARIANTS)
def test_no_english_text_remains(project: Project, variant: str) -> None:
    english_texts = _english_texts(content_of_sample(VARIANTS[variant](project)))
    # Text of a sample warning that has no translation
    assert [text for text in english_texts if text != "These lines do not see it."] == []


def _qualities() -> Iterator[SightingQuality]:
    beams = {"scanner_local": np.zeros(3)}
    yield quality_of(board())
    yield quality_of(board(count=40), **beams)
    yield quality_of(board(noise=0.02), threshold=0.03)
    yield quality_of(board(lambda x, z: 0.1 * x**2))
    yield quality_of(board(lambda x, z: 0.02 * np.sin(40 * x) * np.sin(40 * z)))
    yield quality_of(board() * [1, 1, 1] + [60, 0, 0], **beams)
    some = board()
    yield quality_of(some[(some[:, 0] < -0.3) | (some[:, 2] < -0.3)])
    hidden, alone = (
        ObservedExtent(np.array([0.3, 0.5]), np.array([0.6, 1.0]), 0.25, False),
        ObservedExtent(np.array([0.6, 1.0]), np.array([0.3, 0.5]), 1.0, True),
    )
    yield quality_of(board(), observed_extent=hidden)
    yield quality_of(board(), observed_extent=alone)
    yield replace(
        quality_of(board()),
        reasons=(
            note("quality.narrower", size=0.61, off=0.59, expected=1.2),
            note("quality.less_steep", tilt=1.42, off=0.15, expected=1.57),
            note("quality.sphere_part", share=0.11),
        ),
    )


@pytest.mark.parametrize("calibrated", [True, False])
def test_qualities_are_in_french(project: Project, calibrated: bool) -> None:
    names = [(f"T{k % 2 + 1}", f"L{k // 2 + 1}") for k in range(10)]
    if not calibrated:
        project = replace(project, result=None, validation=(), cross_checks=None)
    made = report_content(
        project, headings_deg={}, counts={}, track_local={}, notes=(), generated=MADE,
        qualities=dict(zip(names, _qualities(), strict=True)),
    )  # fmt: skip
    content = replace(content_of_sample(project), qualities=made.qualities)
    assert len({reason for each in made.qualities for reason in each.reasons}) > 10
    assert _english_texts(content) == ()


@pytest.mark.parametrize("key", [each.key for each in SYSTEMS])
def test_conventions_are_in_french(project: Project, key: str) -> None:
    odd = with_settings(latency=0.001)(with_result(model=StochasticModel("independent"))(project))
    made = report_content(
        odd, headings_deg={}, counts={}, track_local={}, notes=(), generated=MADE, convention=key
    )
    assert made.in_convention is not None
    content = replace(content_of_sample(project), in_convention=made.in_convention)
    assert _english_texts(content) == ()


def _absolute(kind: Literal["scan", "points"], mean: float) -> AbsoluteCheck:
    def state(off: float) -> AbsoluteState:
        far = DistanceStatistics.of(np.abs(np.linspace(off - 0.01, off + 0.01, 50)))
        return AbsoluteState(
            far,
            SignedStatistics(50, off, off, 0.004, 0.001, 0.4),
            SigmaSources(0.002, 0.003, 0.001, 0.001, 0.0005),
            SigmaSources(0.002, 0.003, 0.001, 0.001),
        )

    lines = tuple(
        LineCheck(name, state(-0.08), state(off)) for name, off in (("L1", mean), ("L2", 0.0))
    )
    return AbsoluteCheck(
        reference="quay.xyz", size_bytes=12_345, sha256="a" * 64, kind=kind,
        system="the local frame" if kind == "scan" else "WGS 84 / UTM zone 19N", sigma=0.002,
        search_distance=0.5, lines=lines, all_lines=LineCheck(ALL_LINES, state(-0.08), state(mean)),
        not_compared=(
            note(
                "check.line_not_compared",
                line="L3", reason=error("check.no_reference_near", distance=0.5),
            ),
            note("check.points_not_compared", distance=0.5, points=["P7", "P9"]),
        ),
        bin_edges=(-0.1, 0.0, 0.1), counts_before=(40, 10), counts_after=(20, 30),
        points=() if kind == "scan" else (PointCheck("yes", 2, 0.002, -0.08, mean, 0.004),),
        other_surfaces=None if mean < 0 else (OtherSurface("L1", 10, 0.62),) if mean else (),
    )  # fmt: skip


def test_alternative_methods_are_in_french(project: Project) -> None:
    assert project.result is not None
    for k, (method, off) in enumerate(
        zip(ALTERNATIVE_METHODS, (0.0, 0.3, 0.004, 0.002), strict=True)
    ):
        angles = project.result.boresight + np.radians([off, off, 0.0])
        notes = (note("targetless.basis", used=30, total=99, rounds=3),) * (k == 1)
        alternative = AlternativeResult(
            method, angles, np.array(project.result.covariance), ("L1", "L2"), 30, notes
        )
        project = project.with_alternative_result(alternative)
    content = content_of_sample(project)
    assert [each.method for each in content.methods[1:]] == list(ALTERNATIVE_METHODS)
    assert "report.methods_differ" in {each.code for each in content.warnings}
    assert _english_texts(content) == ()


@pytest.mark.parametrize("kind", ["scan", "points"])
@pytest.mark.parametrize("mean", [-0.05, 0.0, 0.05])
def test_absolute_checks_are_in_french(
    project: Project, kind: Literal["scan", "points"], mean: float
) -> None:
    content = content_of_sample(project.with_absolute(_absolute(kind, mean)))
    assert content.absolute is not None
    assert _english_texts(content) == ()


@pytest.mark.parametrize(
    "known",
    [
        {},
        {"lidar": 0.005, "estimated": ("roll", "pitch", "yaw"), "covariance": np.eye(3) * 1e-7},
        {
            "estimated": (
                "roll",
                "pitch",
                "yaw",
                *LEVER_ARM_NAMES,
                "range_offset",
                "scan_angle_offset",
            ),
            "covariance": np.eye(8) * 1e-7,
        },
    ],
)
def test_error_budgets_are_in_french(project: Project, known: dict[str, Any]) -> None:
    budget = ErrorBudgetValues.of(error_budget(system(**known), (10, 1_000)))
    assert _english_texts(replace(content_of_sample(project), budget=budget)) == ()


@pytest.mark.usefixtures("without_figures")
def test_text_typed_by_the_user_is_kept(project: Project) -> None:
    typed = replace(project.identity, vessel="Points", remarks="Roll. Pitch.", company="up")
    options = ReportOptions(
        language="fr", extent="full", heading="Good.", closing="yes", company="no"
    )
    document = report_document(content_of_sample(replace(project, identity=typed)), {}, options)
    details = dict(document.identity.rows)  # type: ignore[arg-type]
    assert details["Remarques"] == "Roll. Pitch."
    assert "Navire\u202f: Points" in document.project.replace("\u00a0", "\u202f")
    assert document.letterhead.company == "no"
    assert document.letterhead.heading == "Good."
    assert details["Entreprise"] == "up"  # the letterhead is of another company
    closing, signature = document.conclusion
    assert closing == Paragraph("yes")
    assert isinstance(signature, SignatureLines)
    assert signature.values[0] == typed.surveyor
    assert signature.fields[:2] == ("Hydrographe", "Lieu et date")


@pytest.mark.usefixtures("without_figures")
def test_french_report_counts_texts_without_translation(project: Project) -> None:
    content = content_of_sample(project)
    document = report_document(content, {}, FRENCH)
    assert document.language == "fr"
    assert document.title == "Rapport d’étalonnage des angles de visée"
    assert document.notes == ()
    assert report_document(content, {}, FULL_REPORT) == drawn_document(
        undrawn_document(content, {}, FULL_REPORT)
    )


@pytest.mark.usefixtures("without_figures")
def test_numbers_and_names_equal_those_of_the_english_report(project: Project) -> None:
    content = content_of_sample(project)
    english, french = (
        [b for s in report_document(content, {}, options).sections for b in s.blocks]
        for options in (FULL_REPORT, FRENCH)
    )
    for block, french_block in zip(english, french, strict=True):
        if block.kind != "table":
            continue
        for row, french_row in zip(block.rows, french_block.rows, strict=True):  # type: ignore[union-attr]
            for cell, french_cell in zip(row, french_row, strict=True):
                assert _numbers(french_cell, ",", "\u202f") == _numbers(cell, ".", ",")


def _numbers(text: str, decimal: str, group: str) -> list[str]:
    # Sigma is translated as écart-type in most texts.
    text = re.sub("1[ \u00a0]sigma", "", text)
    found = re.findall(rf"[+\u2212\u00b1]?\d(?:[\d{decimal}{group}]*\d)?", text)
    return [each.replace(group, "").replace(decimal, ".") for each in found]


NUMBERS_OF_NAMES = re.compile(r"6\.1\.0|LISPAC \d+\.\d+\.\d+\w*|1980-\S+")


@LONG
@pytest.mark.parametrize("variant", others_long(["as it is", "thesis", "parameters", "components"]))
def test_texts_tables_and_figures_use_the_decimal_comma(project: Project, variant: str) -> None:
    # Import notes are excluded: they quote units as written in the files.
    content = replace(content_of_sample(VARIANTS[variant](project)), notes=())
    with in_language("fr"):
        document = undrawn_document(content, {}, FRENCH)
        blocks = [*document.summary, *(b for section in document.sections for b in section.blocks)]
        drawn_figures: list[Figure] = []
        for picture in undrawn_pictures(blocks):
            drawn = picture.draw(*picture.values)
            drawn_figures += [drawn] if isinstance(drawn, Figure) else drawn
        assert len(drawn_figures) > 4
        shown = []
        for figure in drawn_figures:
            FigureCanvasAgg(figure).draw()
            shown += [text.get_text() for text in figure.findobj(Text)]
    texts = [*document.warnings, *document.notes]
    for block in blocks:
        if isinstance(block, Table):
            texts += [cell for row in block.rows for cell in row]
        elif isinstance(block, Bullets):
            texts += block.items
        elif isinstance(block, Paragraph):
            texts.append(block.text)
    checked = [NUMBERS_OF_NAMES.sub("", text) for text in (*texts, *shown)]
    assert [text for text in checked if re.search(r"\d\.\d", text)] == []
    warnings = (*document.warnings, *document.notes)
    assert [text for text in (*shown, *warnings) if re.search(r"(?<!\w)-\d", text)] == []
    assert sum(bool(re.search(r"\d,\d", text)) for text in shown) > 10


def test_messages_have_true_minus_signs_and_unchanged_names() -> None:
    text = with_minus_signs(
        "After, L1 -3 (-50.0 mm ± 7.7 mm) is off by -2 mm: 2025-06-04.", ["L1 -3"]
    )
    assert text == "After, L1 -3 (\u221250.0 mm ± 7.7 mm) is off by \u22122 mm: 2025-06-04."


@pytest.mark.usefixtures("without_figures")
def test_names_that_are_english_words_are_not_translated(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "before", target="Points")
    document = report_document(content_of_sample(project), {}, FRENCH)
    tables = {b.title: b for s in document.sections for b in s.blocks if b.kind == "table"}
    fits = tables["Ajustement de chaque observation à la surface de sa cible"]
    assert fits.rows[0][0] == "Points"
    assert document.project == "before"


NAMES = ("Board with hole", "Board on line 3", "rock, and roll: hall")


@pytest.mark.parametrize(
    ("case", "name"),
    others_long(
        product(range(len(CASES)), NAMES), lambda pair: pair[1] == NAMES[pair[0] % len(NAMES)]
    ),
)
def test_no_part_of_a_name_is_translated(tmp_path: Path, name: str, case: int) -> None:
    project = sample_project(tmp_path / "p", target=name)
    content = content_of_sample(CASES[case][2](project))
    english = undrawn_document(content, {}, FULL_REPORT)
    with in_language("fr"):
        french = undrawn_document(content, {}, FRENCH)
    before, after = (json.dumps(asdict(d), default=lambda _: "") for d in (english, french))
    assert after.count(name) == before.count(name)


@pytest.mark.usefixtures("rectangles", "usual_gaps")
def test_pdf_html_and_tables_are_french(project: Project, tmp_path: Path) -> None:
    content = content_of_sample(project)
    write_pdf(content, tmp_path / "r.pdf", {}, FRENCH)
    text = _pdf_text(tmp_path / "r.pdf")
    assert "Page 1 sur" in text
    assert "Établi le 2025-06-04 14:03 UTC avec LISPAC" in text
    assert "roulis est positif quand bâbord monte" in re.sub(r"\s+", " ", text)
    page = html_text(content, {}, FRENCH)
    assert '<html lang="fr">' in page
    assert "Table des matières" in page
    write_tables(content, tmp_path / "r.zip", FRENCH)
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        first = archive.namelist()[0]
        assert first == "01-renseignements-sur-le-leve.csv"
        (lines,) = (n for n in archive.namelist() if re.fullmatch(r"\d+-lignes\.csv", n))
        rows = list(csv.reader(archive.read(lines).decode("utf-8-sig").splitlines()))
    assert rows[0] == ["Ligne", "Fichier", "Cap (°)", "Points"]
    assert rows[1] == ["L1", "L1.laz", "0.4", "1234567"]
    assert "-carte-de-v1-" in " ".join(archive.namelist())
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        angles = archive.read("02-angles-de-visee-boresight.csv").decode("utf-8-sig").splitlines()
        (offsets,) = (n for n in archive.namelist() if "comparaison-des-plans" in n)
        planes = archive.read(offsets).decode("utf-8-sig").splitlines()
    for row in list(csv.reader(angles))[1:]:
        assert all(re.fullmatch(r"[+-]?\d+\.\d{4}", number) for number in row[1:-1])
    assert re.search(r"[+-]\d+\.\d \u00b1 \d+\.\d", planes[1])


@pytest.mark.parametrize("language", ["en", "fr"])
def test_csv_has_values_and_does_not_change_texts(language: str) -> None:
    line = LineValues("1,218", "2\u2212x.laz", None, 1234567, ())
    parameter = ParameterValues(
        "lever_x", "m", 0.0, None, -1234.5, 0.0048, None, None, ""
    )  # fmt: skip
    with in_language(language):
        _, *lines = csv.reader(table_csv_text(report_table(LINES_TABLE, [line])).splitlines())
        _, row = csv.reader(
            table_csv_text(report_table(PARAMETERS_TABLE, [parameter])).splitlines()
        )
        facts = [Fact("points", 1234567), Fact("factor", None), Fact("serial", "1,218")]
        values = dict(csv.reader(table_csv_text(facts_table("", facts)).splitlines()))
    assert lines == [["1,218", "2-x.laz", "", "1234567"]]
    # The apostrophe makes a spreadsheet read a text that begins with a sign as a text.
    assert [row[1], *row[3:5]] == ["0.0000 m", "'-1234.5000 m", "0.0048 m"]
    assert values == {"\ufeffpoints": "1234567", "factor": "", "serial": "1,218"}


def test_names_of_manufacturers_have_no_elision(project: Project) -> None:
    for each in SYSTEMS:
        made = report_content(
            project, headings_deg={}, counts={}, track_local={}, notes=(), generated=MADE,
            convention=each.key,
        )  # fmt: skip
        content = replace(content_of_sample(project), in_convention=made.in_convention)
        with in_language("fr"):
            sections = undrawn_document(content, {}, FRENCH).sections
        titles = [b.title for s in sections for b in s.blocks if b.kind == "table"]
        (head,) = (title for title in titles if title.startswith("Convention\u00a0: "))
        assert not re.search(r"(?i)\bde [aeiouyéè]", head)
        assert each.name in head or "Phoenix" in head or "comme iXblue" in head
