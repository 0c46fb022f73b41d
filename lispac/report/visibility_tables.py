"""How visible errors are: a table of all values, and one of the best beside the thesis's."""

from collections.abc import Sequence

import numpy as np

from lispac.report.blocks import Column, Table, rows
from lispac.report.visibility_figures import CRITERIA, error_in_words
from lispac.simulation.thesis_answers import (
    ALL_ERRORS,
    Compared,
    compared_with_thesis,
    lines_for_all_agree,
)
from lispac.simulation.thesis_site import HEADINGS_DEG
from lispac.simulation.visibility_study import Visibility, fewest_lines

NOT_SEEN = "not seen"


def values_table(found: Visibility, errors: Sequence[str]) -> Table:
    """A row for each error, line and inclination; what has no points has no values."""
    heads = (
        "Error", "Line (deg)", "Inclination (deg)", "Points", "Planarity",
        "Centroidal distance (m)", "Type I", "Kept", "Signed orthogonal distance (m)",
        "Angular deviation (deg)",
    )  # fmt: skip
    made = []
    for error in errors:
        e, kept = found.site.errors.index(error), found.kept(error)
        for k, heading in enumerate(HEADINGS_DEG):
            for j, inclination in enumerate(found.site.inclinations):
                place = (e, k, j)
                made.append(
                    (
                        error, f"{heading}", f"{np.degrees(inclination):.0f}",
                        f"{found.points[place]}", _number(found.planarity[place], 4),
                        _number(found.centroidal_distance[place], 5),
                        _number(found.type_one[place], 4), "yes" if inclination in kept else "no",
                        _number(found.orthogonal_distance[place], 6),
                        _number(np.degrees(found.angular_deviation[place]), 5),
                    )
                )  # fmt: skip
    title = f"Visibility on the {found.site.name} site"
    return Table(title, tuple(map(Column, heads)), rows(made))


def reading(found: Visibility, error: str, criterion: str, inclination_deg: float) -> str:
    """What all lines show at the studied inclination nearest to one, in a sentence."""
    shown = CRITERIA[criterion]
    j = int(np.argmin(np.abs(np.degrees(found.site.inclinations) - inclination_deg)))
    values = shown.values(found)[found.site.errors.index(error), :, j]
    said = ", ".join(
        f"{heading}: {_number(value, shown.decimals) or 'no points'}"
        for heading, value in zip(HEADINGS_DEG, values, strict=True)
    )
    return f"{shown.label} at {np.degrees(found.site.inclinations[j]):.0f} deg on line {said}"


def plot_table(found: Visibility, error: str, criterion: str) -> Table:
    """What one figure is drawn from: a row an inclination, a column a line."""
    shown = CRITERIA[criterion]
    values = shown.values(found)[found.site.errors.index(error)]
    return Table(
        f"{error_in_words(error)}: {shown.label}",
        tuple(map(Column, ("Inclination (deg)", *(f"{each} deg" for each in HEADINGS_DEG)))),
        rows(
            (f"{np.degrees(each):.0f}", *(_number(value, 6) for value in values[:, j]))
            for j, each in enumerate(found.site.inclinations)
        ),
    )


def comparison_table(found: Visibility, errors: Sequence[str]) -> Table:
    """The best configuration for each error, here and in the thesis, and whether they agree."""
    heads = (
        "Error", "Kept (deg)", "Thesis keeps", "Best (deg)", "Thesis's best", "Lines that differ",
        "Thesis's lines", "Inclination is", "Lines are", "Why not",
    )  # fmt: skip
    made = [_compared(each) for each in compared_with_thesis(found) if each.best.error in errors]
    title = f"Best configurations on the {found.site.name} site"
    return Table(title, tuple(map(Column, heads)), rows(made))


def all_errors_in_words(found: Visibility) -> str:
    """Which lines show every error, on the terrestrial site beside table 3.3 of the thesis."""
    sets = fewest_lines([found.best(error) for error in found.site.errors])
    agree = "the same as" if lines_for_all_agree(found) else "others than"
    beside = f" ({agree} the {len(ALL_ERRORS)} of the thesis's table 3.3)"
    return (
        f"Fewest lines that show every error: {'; '.join(_headings(lines) for lines in sets)}"
        f"{beside if found.site.name == 'terrestrial' else ''}."
    )


def _compared(each: Compared) -> tuple[str, ...]:
    best, stated = each.best, each.stated
    kept = [f"{np.degrees(end):.0f}" for end in (best.kept[0], best.kept[-1])] if best.kept else []
    thesis = stated.inclination_deg
    return (
        error_in_words(best.error),
        " to ".join(kept) or "none",
        "{} to {}".format(*stated.kept_deg),
        NOT_SEEN if best.inclination is None else f"{np.degrees(best.inclination):.0f}",
        NOT_SEEN if thesis is None else _about(*thesis),
        # Lines that show the same stand together; one of each group is enough.
        ", ".join("/".join(map(str, group)) for group in best.groups) if best.lines else NOT_SEEN,
        _headings(stated.lines) or NOT_SEEN,
        _agree(each.inclination_agrees),
        _agree(each.lines_agree),
        each.reason,
    )


def _about(low: int, high: int) -> str:
    return f"{low}" if low == high else f"about {(low + high) / 2:.0f}"


def _agree(agree: bool) -> str:
    return "the same" if agree else "different"


def _headings(lines: Sequence[int]) -> str:
    return ", ".join(map(str, lines))


def _number(value: float, decimals: int) -> str:
    return f"{value:.{decimals}f}" if np.isfinite(value) else ""
