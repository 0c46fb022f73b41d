"""The sections on reliability and cross-checks: whether the data agree with themselves."""

from collections.abc import Sequence

from lispac.adjustment.shown import SPREAD_LINES, SPREAD_TARGETS
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, rows
from lispac.report.values import (
    Adjustment,
    CheckedPart,
    CrossChecked,
    ReportContent,
    SightingCheck,
)
from lispac.report.wording import UNKNOWN, angle, known, listed, mm, named_parts, signed


def reliability(content: ReportContent) -> list[Block]:
    """How far each sighting and each point is checked by all others."""
    adjustment = content.adjustment
    if adjustment is None:
        return []
    if not adjustment.reliability or adjustment.critical_w is None:
        thesis = content.settings.pos_errors == "independent"
        why = (
            "that has no error in common to a sighting's points"
            if thesis
            else "with the surface sigma held at zero"
        )
        return [Paragraph(f"Sightings are not tested by the model used here, {why}.")]
    found = adjustment.reliability
    return [
        Paragraph(
            "Each sighting is compared with what all others say of it. Shift: how far it lies off "
            "along the surface's normal. w: the shift over its sigma; beyond "
            f"{adjustment.critical_w:.2f} the sighting disagrees (1 % chance that any of "
            f"{len(found)} does so without a fault). Detectable: the smallest shift that the test "
            "finds 4 times in 5. Effect: what a shift of that size, not found, does to the angles."
        ),
        _test_table(found),
        *_told(found),
        Paragraph(
            "Single points are tested alike. Redundancy: how far the other data check each point, "
            "from 0 (not at all) to 1. Strays: points farther off than 3.29 of their sigmas, which "
            "one in a thousand exceeds by chance. Largest w: that of the point farthest off, by "
            "its sigma, and the time by which it is found in the line; averaged points have the "
            "mean of their times."
        ),
        _point_table(found),
        *_pos_errors(adjustment),
    ]


def _test_table(found: Sequence[SightingCheck]) -> Table:
    return Table(
        "Agreement of the sightings",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            Column("Shift\n(mm)"),
            Column("w"),
            Column("Detectable\n(mm)"),
            Column("Effect, roll\n(deg)"),
            Column("Pitch\n(deg)"),
            Column("Yaw\n(deg)"),
            Column("Finding", "left"),
        ),
        rows(
            [
                s.target,
                s.line,
                known(s.shift_m, lambda v: signed(1000 * v, 1)),
                known(s.w, lambda v: signed(v, 1)),
                known(s.detectable_m, mm),
                *([UNKNOWN] * 3 if s.effect_deg is None else [angle(v) for v in s.effect_deg]),
                s.in_words,
            ]
            for s in found
        ),
    )


def _point_table(found: Sequence[SightingCheck]) -> Table:
    return Table(
        "Tests of single points",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            Column("Points"),
            Column("Redundancy"),
            Column("Outliers"),
            Column("Largest w"),
            Column("Its time (s)"),
        ),
        rows(
            [
                s.target,
                s.line,
                f"{s.points:,}",
                f"{s.redundancy:.2f}",
                str(s.strays),
                f"{s.largest_w:.1f}",
                known(s.largest_w_time_s, lambda v: f"{v:.3f}"),
            ]
            for s in found
        ),
    )


def _told(found: Sequence[SightingCheck]) -> list[Block]:
    said = []
    for sighting in found:
        where = f"{sighting.target} on line {sighting.line}"
        if sighting.released:
            said.append(
                f"{where} lies off what all others say; it is left out: the answer would be the "
                "same without it."
            )
        elif sighting.in_words == "disagrees":
            said.append(
                f"{where} disagrees but takes part: with too few other sightings of the target, "
                "or without a loss, none is left out."
            )
    unchecked = [f"{s.target} on line {s.line}" for s in found if s.in_words == "not checked"]
    if unchecked:
        said.append(f"No other data check {listed(unchecked)}.")
    return [Bullets(tuple(said))] if said else []


def _pos_errors(adjustment: Adjustment) -> list[Block]:
    # Rounded first, plus zero: no minus sign before a zero
    from lispac.report.figures import POS_COMPONENTS, pos_error_figures_of

    found = adjustment.reliability
    count = len(found)

    def mean(values: Sequence[float]) -> float:
        return sum(values) / count

    prior = [
        *(mm(mean([s.pos_sigma_m[k] for s in found])) for k in range(3)),
        *(f"{mean([s.pos_sigma_deg[k] for s in found]):.4f}" for k in range(3)),
    ]
    table = Table(
        "Estimated POS error in the middle of each sighting",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            *(
                Column(f"{name}\n({'mm' if k < 3 else 'deg'})")
                for k, name in enumerate(POS_COMPONENTS)
            ),
        ),
        rows(
            [
                *(
                    [
                        s.target,
                        s.line,
                        *(signed(round(1000 * v, 1) + 0.0, 1) for v in s.pos_error_m),
                        *(angle(round(v, 4) + 0.0) for v in s.pos_error_deg),
                    ]
                    for s in found
                ),
                ["Given 1 σ", "mean", *prior],
            ]
        ),
    )
    caption = (
        "Estimated POS error of each sighting with its 2 sigma (bar); grey: the prior 2 sigma. "
        "Errors beyond the grey are red: the POS was worse than stated, or something else is taken "
        "for its error."
    )
    return [table, Drawing(caption, pos_error_figures_of, (found,))]


def cross_checks(content: ReportContent) -> list[Block]:
    """What parts of the data say by themselves."""
    if content.adjustment is None:
        return []
    checks = content.cross_checks
    if checks is None:
        return [Paragraph("No part of the data has been adjusted by itself.")]
    blocks: list[Block] = [
        Paragraph(
            "The adjustment is repeated without each line, without each target, and with each half "
            "of the lines in the order they were sailed. The spread is the 1 sigma of the angles "
            "that the answers without one line, or one target, give by themselves (jackknife); it "
            "relies on no stated sigma."
        ),
        _spread_table(content, checks),
    ]
    absent = [
        what
        for what, spread in (
            ("one line", checks.spread_lines_deg), ("one target", checks.spread_targets_deg)
        )
        if spread is None
    ]  # fmt: skip
    if absent:
        blocks.append(
            Paragraph(
                f"The spread with {' or '.join(absent)} left out needs three of them, and an "
                "answer without each."
            )
        )
    blocks += [
        _parts_table(content, checks),
        Paragraph(
            "Over its sigma: the difference over the standard deviation it should have. Beyond 3 "
            "the part disagrees with the whole, or one half with the other, by more than chance "
            "explains."
        ),
    ]
    reasons = tuple(f"{name}: {part.reason}" for name, part in named_parts(checks) if part.reason)
    if reasons:
        blocks += [Paragraph("Without an answer:"), Bullets(reasons)]
    return blocks


def _spread_table(content: ReportContent, checks: CrossChecked) -> Table:
    spreads = (
        ("Formal", checks.sigma_deg),
        (SPREAD_LINES, checks.spread_lines_deg),
        (SPREAD_TARGETS, checks.spread_targets_deg),
    )
    return Table(
        "1 sigma of the angles, formal and by the spread of the parts",
        (Column("", "left"), *(Column(f"{a.name.capitalize()}\n(deg)") for a in content.angles)),
        rows(
            [name, *([UNKNOWN] * 3 if values is None else [f"{v:.4f}" for v in values])]
            for name, values in spreads
        ),
    )


def _parts_table(content: ReportContent, checks: CrossChecked) -> Table:
    angles = [angle.name.capitalize() for angle in content.angles]
    return Table(
        "Answers of parts of the data, as differences from the whole",
        (
            Column("Part", "left"),
            *(Column(f"{a}\n(deg)") for a in angles),
            *(Column(f"{a} over\nits sigma") for a in angles),
            Column("Finding", "left"),
        ),
        rows(
            [
                name,
                *_shown(part.difference_deg, 4),
                *_shown(part.significance, 1),
                _finding(part),
            ]
            for name, part in named_parts(checks)
        ),
    )


def _shown(values: tuple[float, ...] | None, decimals: int) -> list[str]:
    return [UNKNOWN] * 3 if values is None else [signed(value, decimals) for value in values]


def _finding(part: CheckedPart) -> str:
    if part.boresight_deg is None:
        return "no answer"
    return "disagrees" if part.disagrees else "agrees"
