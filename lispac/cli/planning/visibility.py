"""``lispac visibility``: effect of systematic errors on a board by inclination and line."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.message_texts import message_text

if TYPE_CHECKING:
    from lispac.report.document_blocks import Table
    from lispac.simulation.thesis_comparison import ThesisComparison
    from lispac.simulation.visibility_study import BestConfiguration


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "site", choices=("terrestrial", "marine"),
        help="terrestrial: vehicle 2.5 m above a board on the ground; marine: vessel 15 m from a "
             "quay 5 m high",
    )  # fmt: skip
    parser.add_argument("--output", type=Path, required=True, metavar="DIR", help="output folder")
    parser.add_argument(
        "--error", nargs="+", metavar="NAME",
        choices=(
            "roll", "pitch", "yaw", "lever-x", "lever-y", "lever-z", "range-offset",
            "scan-angle-offset",
        ),
        help="errors to simulate (default: all of the site): roll, pitch, yaw, lever-x, lever-y, "
             "lever-z, range-offset, scan-angle-offset",
    )  # fmt: skip
    parser.add_argument(
        "--formats", nargs="+", choices=("png", "svg", "pdf"), default=["png"],
        help="formats of the figures (default png)",
    )  # fmt: skip
    parser.add_argument(
        "--hit-beams", action="store_true",
        help="use the beams that hit the board in the presence of the error, as in a real survey, "
             "instead of the beams aimed at it, as in Shahraji's thesis",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Simulate a site, write tables and figures, and compare with the thesis.

    With ``--hit-beams`` there is no comparison, since the thesis aims the beams at the board.

    Raises
    ------
    UsageError
        If a systematic error is not simulated on this site.
    """
    from lispac.report.visibility_tables import all_errors_text, comparison_table
    from lispac.simulation.thesis_comparison import compare_with_thesis
    from lispac.simulation.thesis_site import SITES
    from lispac.simulation.visibility_study import study_visibility as study
    from lispac.workflow.planning.visibility import write_visibility

    site = SITES[arguments.site]
    errors = [error.replace("-", "_") for error in arguments.error or site.errors]
    unknown = [error for error in errors if error not in site.errors]
    if unknown:
        raise UsageError(
            f"--error {unknown[0].replace('_', '-')}: the {site.name} site has "
            f"{', '.join(error.replace('_', '-') for error in site.errors)} only"
        )
    with ConsoleProgress() as progress:
        found = study(site, "struck" if arguments.hit_beams else "aimed", progress=progress)
        written = write_visibility(
            found, arguments.output, errors, arguments.formats, progress=progress
        )
    if arguments.json:
        print_json(
            {
                "site": site.name,
                "beams": found.beams,
                "best": [_best_values(found.best_configuration(error)) for error in errors],
                "thesis": [] if arguments.hit_beams else [
                    _thesis_values(each)
                    for each in compare_with_thesis(found)
                    if each.best.error in errors
                ],
                "files": [str(path) for path in written],
            }
        )  # fmt: skip
        return
    if not arguments.hit_beams:
        _print_table(comparison_table(found, errors))
        print(all_errors_text(found))
    print(f"{len(written)} files in {arguments.output}")


def _best_values(best: BestConfiguration) -> dict[str, Any]:
    import numpy as np

    chosen = best.inclination
    return {
        "error": best.error,
        "suitable_inclinations_deg": [round(float(np.degrees(each))) for each in best.kept],
        "inclination_deg": None if chosen is None else round(float(np.degrees(chosen))),
        "groups_of_lines_deg": best.groups,
    }


def _thesis_values(each: ThesisComparison) -> dict[str, Any]:
    return {
        "error": each.best.error,
        **asdict(each.thesis),
        "lines_agree": each.lines_agree,
        "inclination_agrees": each.inclination_agrees,
        "reason": "" if each.reason is None else message_text(each.reason),
    }


def _print_table(table: Table) -> None:
    """Print a table as text; the sentences of its last column are printed below it."""
    *heads, _why = [column.title for column in table.columns]
    lines = [heads, *(row[:-1] for row in table.rows)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(heads))]
    for line in lines:
        print("  ".join(f"{cell:{width}s}" for cell, width in zip(line, widths, strict=True)))
    print()
    for row in table.rows:
        if row[-1]:
            print(f"{row[0]}: {row[-1]}")
