"""Tables of the visibility of errors, and of the best configurations compared with the thesis."""

from collections.abc import Mapping, Sequence

import numpy as np

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.text_format import fixed_number
from lispac.report.document_blocks import Column, Table, as_rows
from lispac.report.visibility_figures import CRITERIA, systematic_error_label
from lispac.simulation.thesis_comparison import (
    SUFFICIENT_HEADINGS_DEG,
    ThesisComparison,
    compare_with_thesis,
    do_fewest_lines_agree,
)
from lispac.simulation.thesis_site import HEADINGS_DEG
from lispac.simulation.visibility_study import VisibilityStudy, fewest_sufficient_lines

VALUES_TABLE_TITLES: Mapping[str, str] = {
    "terrestrial": N_("Effects of systematic errors on the terrestrial site"),
    "marine": N_("Effects of systematic errors on the marine site"),
}
COMPARISON_TABLE_TITLES: Mapping[str, str] = {
    "terrestrial": N_("Best configurations on the terrestrial site"),
    "marine": N_("Best configurations on the marine site"),
}
"""Titles of both tables, by the name of the site."""
VALUES_COLUMN_TITLES = (
    N_("Error"), N_("Line (deg)"), N_("Inclination (deg)"), N_("Points"), N_("Planarity"),
    N_("Centroidal distance (m)"), N_("Type I criterion (0 to 1)"), N_("Accepted"),
    N_("Signed orthogonal distance (m)"), N_("Angular deviation (deg)"),
)  # fmt: skip
COMPARISON_COLUMN_TITLES = (
    N_("Error"), N_("Accepted incl. (deg)"), N_("Accepted incl. in Shahraji's thesis"),
    N_("Best incl. (deg)"), N_("Best incl. in Shahraji's thesis"), N_("Required lines"),
    N_("Required lines in Shahraji's thesis"), N_("Inclination (vs. thesis)"),
    N_("Lines (vs. thesis)"), N_("Reason"),
)  # fmt: skip
"""Titles of the columns of both tables; the inclinations of Shahraji's thesis are in degrees."""


def values_table(study: VisibilityStudy, errors: Sequence[str]) -> Table:
    """Table with a row for each error, line and inclination; values are empty without points."""
    made = []
    for error in errors:
        e, kept = study.site.errors.index(error), study.kept_inclinations(error)
        for k, heading in enumerate(HEADINGS_DEG):
            for j, inclination in enumerate(study.site.inclinations):
                place = (e, k, j)
                made.append(
                    (
                        error, f"{heading}", f"{np.degrees(inclination):.0f}",
                        f"{study.points[place]}", _number_text(study.planarity[place], 4),
                        _number_text(study.centroidal_distance[place], 5),
                        _number_text(study.type_one[place], 4),
                        gettext("yes") if inclination in kept else gettext("no"),
                        _number_text(study.orthogonal_distance[place], 6),
                        _number_text(np.degrees(study.angular_deviation[place]), 5),
                    )
                )  # fmt: skip
    return Table(
        gettext(VALUES_TABLE_TITLES[study.site.name]),
        _table_columns(VALUES_COLUMN_TITLES),
        as_rows(made),
    )


def values_at_inclination(
    study: VisibilityStudy, error: str, criterion: str, inclination_deg: float
) -> str:
    """Text with the values of all lines at the studied inclination nearest to the given one."""
    shown = CRITERIA[criterion]
    j = int(np.argmin(np.abs(np.degrees(study.site.inclinations) - inclination_deg)))
    values = shown.values(study)[study.site.errors.index(error), :, j]
    lines = [
        gettext(
            "{heading:n} deg: {value}", heading=heading, value=_value_text(value, shown.decimals)
        )
        for heading, value in zip(HEADINGS_DEG, values, strict=True)
    ]
    return gettext(
        "{quantity} at an inclination of {inclination:deg.0} deg, by heading of the line: {values}",
        quantity=gettext(shown.label), inclination=study.site.inclinations[j],
        values="; ".join(lines),
    )  # fmt: skip


def _value_text(value: float, decimals: int) -> str:
    return fixed_number(value, decimals) if np.isfinite(value) else gettext("no points")


def plot_table(study: VisibilityStudy, error: str, criterion: str) -> Table:
    """Values of one figure: a row for each inclination, a column for each line."""
    shown = CRITERIA[criterion]
    values = shown.values(study)[study.site.errors.index(error)]
    return Table(
        gettext(
            "{error}: {quantity}",
            error=systematic_error_label(error),
            quantity=gettext(shown.label),
        ),
        (
            Column(gettext("Inclination (deg)")),
            *(Column(gettext("{heading:n} deg", heading=each)) for each in HEADINGS_DEG),
        ),
        as_rows(
            (f"{np.degrees(each):.0f}", *(_number_text(value, 6) for value in values[:, j]))
            for j, each in enumerate(study.site.inclinations)
        ),
    )


def comparison_table(study: VisibilityStudy, errors: Sequence[str]) -> Table:
    """Best configuration for each error, here and in the thesis, and their agreement."""
    made = [
        _comparison_row(each) for each in compare_with_thesis(study) if each.best.error in errors
    ]
    return Table(
        gettext(COMPARISON_TABLE_TITLES[study.site.name]),
        _table_columns(COMPARISON_COLUMN_TITLES),
        as_rows(made),
    )


def _table_columns(titles: Sequence[str]) -> tuple[Column, ...]:
    return tuple(Column(gettext(each)) for each in titles)


def all_errors_text(study: VisibilityStudy) -> str:
    """Text on the smallest sets of lines that reveal all errors, compared with thesis table 3.3."""
    sets = fewest_sufficient_lines([study.best_configuration(error) for error in study.site.errors])
    if study.site.name != "terrestrial":
        template = N_("Smallest sets of lines that reveal all errors: {lines}.")
    elif do_fewest_lines_agree(study):
        template = N_(
            "Smallest sets of lines that reveal all errors: {lines} (the same as the {count:n} "
            "sets in table 3.3 of Shahraji's thesis)."
        )
    else:
        template = N_(
            "Smallest sets of lines that reveal all errors: {lines} (different from the {count:n} "
            "sets in table 3.3 of Shahraji's thesis)."
        )
    return gettext(
        template, lines="; ".join(map(_headings_text, sets)), count=len(SUFFICIENT_HEADINGS_DEG)
    )


def _comparison_row(each: ThesisComparison) -> tuple[str, ...]:
    best, thesis_value = each.best, each.thesis
    accepted = gettext("none")
    if best.kept:
        accepted = _range_text(
            *(round(float(np.degrees(end))) for end in (best.kept[0], best.kept[-1]))
        )
    not_seen, thesis = gettext("not visible"), thesis_value.inclination_deg
    return (
        systematic_error_label(best.error),
        accepted,
        _range_text(*thesis_value.suitable_inclinations_deg),
        not_seen if best.inclination is None else f"{np.degrees(best.inclination):.0f}",
        not_seen if thesis is None else _inclination_text(*thesis),
        # Lines that reveal the error equally well form a group, of which one line is sufficient.
        ", ".join("/".join(map(str, group)) for group in best.groups) if best.lines else not_seen,
        _headings_text(thesis_value.lines) or not_seen,
        _agreement_text(each.inclination_agrees),
        _agreement_text(each.lines_agree),
        "" if each.reason is None else message_text(each.reason),
    )


def _range_text(low: float, high: float) -> str:
    return gettext("{low} to {high}", low=f"{low}", high=f"{high}")


def _inclination_text(low: int, high: int) -> str:
    if low == high:
        return f"{low}"
    return gettext("about {inclination}", inclination=f"{(low + high) / 2:.0f}")


def _agreement_text(agree: bool) -> str:
    return gettext("the same") if agree else gettext("different")


def _headings_text(lines: Sequence[int]) -> str:
    return ", ".join(map(str, lines))


def _number_text(value: float, decimals: int) -> str:
    return f"{value:.{decimals}f}" if np.isfinite(value) else ""
