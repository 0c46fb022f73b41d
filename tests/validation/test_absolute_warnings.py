"""Tests of the warnings on page one about a check against a reference."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.message_texts import message_text
from lispac.messages import Level, Value
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.report.document import undrawn_document
from lispac.report.document_blocks import Paragraph
from lispac.validation.absolute_check import (
    ALL_LINES,
    AbsoluteCheck,
    AbsoluteState,
    LineCheck,
    PointCheck,
    SigmaSources,
)
from lispac.validation.comparison_results import DistanceStatistics, SignedStatistics
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

SIGMA = 0.012
LINES = ("L1", "L2", "L3", "L4", "L5", "L6")


def check(
    off: dict[str, float], *, rms: float = SIGMA, points: tuple[PointCheck, ...] = ()
) -> AbsoluteCheck:
    """Check of six lines with a sigma of 12 mm each.

    The 95 % limit is 23.5 mm for a single line and 31.7 mm for the largest of six (Sidak and
    Bonferroni agree to a tenth of a millimetre).
    """

    def state(mean: float) -> AbsoluteState:
        known = SigmaSources(0.0, SIGMA, 0.0, 0.0)
        far = replace(DistanceStatistics.of(np.full(50, rms)), rms=rms)
        return AbsoluteState(far, SignedStatistics(50, mean, mean, rms, 0.0, 0.0), known, known)

    lines = tuple(LineCheck(n, state(-0.1), state(off.get(n, 0.0))) for n in LINES)
    return AbsoluteCheck(
        "quay.laz", 1, "a" * 64, "points" if points else "scan", "the local frame", 0.0, 1.0, lines,
        LineCheck(ALL_LINES, state(-0.1), state(off.get(ALL_LINES, 0.0))), (), (-0.1, 0.1), (50,),
        (50,), points,
    )  # fmt: skip


def shown_warnings(
    folder: Path, found: AbsoluteCheck
) -> dict[str, tuple[Level, str, Mapping[str, Value]]]:
    """Level, text and parameters of each warning on the check, by code."""
    content = sample_content(sample_project(folder).with_absolute(found))
    return {
        each.code: (each.level, message_text(each), each.params)
        for each in content.warnings
        if each.code.startswith("report.absolute")
    }


@pytest.mark.parametrize(
    ("off", "level"),
    [(0.023, None), (0.028, Level.NOTE), (-0.028, Level.NOTE), (0.033, Level.WARNING)],
)
def test_a_single_line(tmp_path: Path, off: float, level: Level | None) -> None:
    found = shown_warnings(tmp_path, check({"L3": off}))
    if level is None:
        assert found == {}
        return
    ((code, (how, text, params)),) = found.items()
    by_chance = "_by_chance" if level is Level.NOTE else ""
    assert (code, how) == (f"report.absolute_line_off{by_chance}", level)
    assert (params["count"], params["total"]) == (1, 6)
    assert f"L3 ({1000 * off:+.1f} mm, ± 23.5 mm)" in text


def test_several_lines_agree_in_number(tmp_path: Path) -> None:
    (found,) = shown_warnings(tmp_path, check({"L1": 0.03, "L2": 0.03})).values()
    assert (found[2]["count"], found[2]["total"]) == (2, 6)


def test_surveyed_planes(tmp_path: Path) -> None:
    def plane(name: str, after: float, half: float | None) -> PointCheck:
        return PointCheck(name, 6, 0.001, -0.2, after, half)

    good, unknown = plane("T1", -0.004, 0.025), plane("OLD", -0.2, None)
    assert shown_warnings(tmp_path, check({}, points=(good, unknown))) == {}
    found = shown_warnings(tmp_path, check({}, points=(good, plane("T2", -0.1843, 0.025))))
    assert found["report.absolute_point_off"][0] is Level.WARNING
    assert "from 1 of 2 surveyed" in found["report.absolute_point_off"][1]
    assert "T2 (-184.3 mm, ± 25.0 mm)" in found["report.absolute_point_off"][1]


@pytest.mark.parametrize(("times", "level"), [(1.9, None), (2.5, Level.NOTE), (3.7, Level.WARNING)])
def test_the_rms(tmp_path: Path, times: float, level: Level | None) -> None:
    found = shown_warnings(tmp_path, check({}, rms=times * SIGMA))
    assert found.get("report.absolute_rms", (None, ""))[0] == level
    if level:
        assert f"{times:.1f} times the 12.0 mm" in found["report.absolute_rms"][1]


@pytest.mark.parametrize(
    ("off", "code"),
    [(0.0, None), (0.05, "report.absolute_nearer"), (-0.05, "report.absolute_farther")],
)
def test_page_one_has_one_sentence_or_warning_for_each_check(
    tmp_path: Path, off: float, code: str | None
) -> None:
    found = check({ALL_LINES: off})
    content = sample_content(sample_project(tmp_path).with_absolute(found))
    document = undrawn_document(content, {}, FULL_REPORT)
    first = message_text(AbsoluteCheckValues.of(found).messages[0])
    sentences = [b.text for b in document.summary if isinstance(b, Paragraph) and first in b.text]
    warnings = [
        each for each in content.warnings if "nearer" in each.code or "farther" in each.code
    ]
    assert [each.code for each in warnings] == ([] if code is None else [code])
    assert len(sentences) + len(warnings) == 1
    for each in warnings:
        assert each.params["mean"] == abs(off)
        assert message_text(each) in document.warnings
