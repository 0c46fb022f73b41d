"""What page one says of a check against a reference: all lines, single ones, points and the RMS."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.report.absolute_values import Absolute
from lispac.report.blocks import Paragraph
from lispac.report.document import in_english
from lispac.report.options import ReportOptions
from lispac.validation.absolute import (
    ALL_LINES,
    AbsoluteCheck,
    AbsoluteState,
    Explained,
    LineCheck,
    PointCheck,
)
from lispac.validation.results import DistanceStatistics, SignedStatistics
from tests.report_sample import sample_content, sample_project

SIGMA = 0.012
LINES = ("L1", "L2", "L3", "L4", "L5", "L6")


def check(
    off: dict[str, float], *, rms: float = SIGMA, points: tuple[PointCheck, ...] = ()
) -> AbsoluteCheck:
    """Six lines, each of 12 mm: what the largest of them keeps within.

    95 % of single ones within 23.5 mm, of the largest of six within 31.7 mm (Sidak and Bonferroni
    agree to a tenth).
    """

    def state(mean: float) -> AbsoluteState:
        known = Explained(0.0, SIGMA, 0.0, 0.0)
        far = replace(DistanceStatistics.of(np.full(50, rms)), rms=rms)
        return AbsoluteState(far, SignedStatistics(50, mean, mean, rms, 0.0, 0.0), known, known)

    lines = tuple(LineCheck(n, state(-0.1), state(off.get(n, 0.0))) for n in LINES)
    return AbsoluteCheck(
        "quay.laz", 1, "a" * 64, "points" if points else "scan", "the local frame", 0.0, 1.0, lines,
        LineCheck(ALL_LINES, state(-0.1), state(off.get(ALL_LINES, 0.0))), (), (-0.1, 0.1), (50,),
        (50,), points,
    )  # fmt: skip


def told(folder: Path, found: AbsoluteCheck) -> dict[str, tuple[str, str]]:
    content = sample_content(sample_project(folder).with_absolute(found))
    return {c.code: (c.severity, c.text) for c in content.cautions if c.code.startswith("absolute")}


@pytest.mark.parametrize(
    ("off", "severity"),
    [(0.023, None), (0.028, "caution"), (-0.028, "caution"), (0.033, "serious")],
)
def test_a_single_line(tmp_path: Path, off: float, severity: str | None) -> None:
    found = told(tmp_path, check({"L3": off}))
    if severity is None:
        assert found == {}
        return
    ((code, (how, text)),) = found.items()
    assert (code, how) == ("absolute_line_off", severity)
    assert "1 of 6 lines is off by more than its own errors explain" in text
    assert f"L3 ({1000 * off:+.1f} mm, ± 23.5 mm)" in text.replace("\N{MINUS SIGN}", "-")
    assert ("by chance" in text) == (severity == "caution")


def test_several_lines_agree_in_number(tmp_path: Path) -> None:
    (text,) = (t for _, t in told(tmp_path, check({"L1": 0.03, "L2": 0.03})).values())
    assert "2 of 6 lines are off by more than their own errors explain" in text


def test_surveyed_planes(tmp_path: Path) -> None:
    def plane(name: str, after: float, half: float | None) -> PointCheck:
        return PointCheck(name, 6, 0.001, -0.2, after, half)

    good, unknown = plane("T1", -0.004, 0.025), plane("OLD", -0.2, None)
    assert told(tmp_path, check({}, points=(good, unknown))) == {}
    found = told(tmp_path, check({}, points=(good, plane("T2", -0.1843, 0.025))))
    assert found["absolute_point_off"][0] == "serious"
    assert "(1 of 2)" in found["absolute_point_off"][1]
    assert "T2 (\N{MINUS SIGN}184.3 mm, ± 25.0 mm)" in found["absolute_point_off"][1]


@pytest.mark.parametrize(("times", "severity"), [(1.9, None), (2.5, "caution"), (3.7, "serious")])
def test_the_rms(tmp_path: Path, times: float, severity: str | None) -> None:
    found = told(tmp_path, check({}, rms=times * SIGMA))
    assert found.get("absolute_rms", (None, ""))[0] == severity
    if severity:
        assert f"{times:.1f} times the 12.0 mm" in found["absolute_rms"][1]


def test_page_one_has_a_line_of_every_check(tmp_path: Path) -> None:
    for off in (0.0, 0.05):
        found = check({ALL_LINES: off})
        content = sample_content(sample_project(tmp_path).with_absolute(found))
        document = in_english(content, {}, ReportOptions())
        said = [b.text for b in document.summary if isinstance(b, Paragraph)]
        said += document.serious
        first = Absolute.of(found).in_words[0]
        assert sum(first in text for text in said) == 1
