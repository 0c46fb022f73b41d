"""Files on the visibility of errors on boards: values, best configurations, figures."""

from collections.abc import Sequence
from pathlib import Path

from lispac.io.files import atomic_write
from lispac.language import gettext_lazy
from lispac.progress import Progress, no_progress
from lispac.report.csv_tables import csv_text
from lispac.report.visibility_figures import CRITERIA, visibility_figure
from lispac.report.visibility_tables import comparison_table, values_table
from lispac.simulation.visibility_study import VisibilityStudy

RESOLUTION = 200
"""Resolution of a PNG, dots per inch."""


def write_visibility(
    study: VisibilityStudy,
    folder: Path,
    errors: Sequence[str],
    formats: Sequence[str],
    *,
    progress: Progress = no_progress,
) -> list[Path]:
    """Write a site's tables and the three figures of each error.

    Parameters
    ----------
    errors : of the site
    formats : png, svg or pdf, of the figures

    Returns
    -------
    list of Path
        Written files.

    Raises
    ------
    InputError
        If a file cannot be written.
    """
    tables = [("values", values_table(study, errors))]
    if study.beams == "aimed":  # those of the thesis
        tables.append(("best", comparison_table(study, errors)))
    written = []
    for name, table in tables:
        path = folder / f"{study.site.name}-{name}.csv"
        with atomic_write(path) as part:
            # A spreadsheet's line ends are those the writer put there.
            part.write_text(csv_text(table), encoding="utf-8", newline="")
        written.append(path)
    drawn = [(error, criterion, form) for error in errors for criterion in CRITERIA
             for form in formats]  # fmt: skip
    for k, (error, criterion, form) in enumerate(drawn):
        progress(k / len(drawn), gettext_lazy("Drawing the figures"))
        name = f"{study.site.name}-{error.replace('_', '-')}-{criterion}.{form}"
        with atomic_write(folder / name) as part:
            visibility_figure(study, error, criterion).savefig(part, format=form, dpi=RESOLUTION)
        written.append(folder / name)
    return written
