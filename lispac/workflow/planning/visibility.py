"""Files on the visibility of errors on boards: values, best configurations, figures."""

from collections.abc import Sequence
from pathlib import Path

from lispac.io.files import atomic_write
from lispac.language import gettext_lazy
from lispac.present.planning import visibility
from lispac.progress import Progress, no_progress
from lispac.report.csv_tables import table_csv_text
from lispac.report.document_blocks import report_table
from lispac.report.visibility_figures import visibility_figure
from lispac.simulation.visibility_study import VisibilityStudy

PNG_RESOLUTION_DPI = 200
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
    errors : names of the errors of the site
    formats : file types of the figures: png, svg, pdf

    Returns
    -------
    list of Path
        Written files.

    Raises
    ------
    InputError
        If a file cannot be written.
    """
    tables = [
        (
            "values",
            report_table(
                visibility.ERRORS_ON_BOARDS_TABLE, visibility.errors_on_boards(study, errors)
            ),
        )
    ]
    if study.beams == "aimed":  # as in the thesis
        rows = visibility.compared_configurations(study, errors)
        tables.append(("best", report_table(visibility.CONFIGURATIONS_WITH_REASONS_TABLE, rows)))
    written = []
    for name, table in tables:
        path = folder / f"{study.site.name}-{name}.csv"
        with atomic_write(path) as part:
            # The table already contains the line ends that spreadsheets expect.
            part.write_text(table_csv_text(table), encoding="utf-8", newline="")
        written.append(path)
    drawn = [(error, criterion, form) for error in errors for criterion in visibility.CRITERIA
             for form in formats]  # fmt: skip
    for k, (error, criterion, form) in enumerate(drawn):
        progress(k / len(drawn), gettext_lazy("Drawing the figures"))
        name = f"{study.site.name}-{error.replace('_', '-')}-{criterion}.{form}"
        with atomic_write(folder / name) as part:
            visibility_figure(study, error, criterion).savefig(
                part, format=form, dpi=PNG_RESOLUTION_DPI
            )
        written.append(folder / name)
    return written
