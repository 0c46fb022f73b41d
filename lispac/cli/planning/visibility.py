"""``lispac visibility``: effect of systematic errors on a board by inclination and line."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, print_json, print_table
from lispac.cli.messages import console_text
from lispac.language import to_plain_text


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
    from lispac.present.planning import visibility
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
    compared = [] if arguments.hit_beams else visibility.compared_configurations(found, errors)
    if arguments.json:
        from lispac.cli.json_outputs import VisibilityOutput

        best = tuple(
            visibility.ConfigurationValues.of(found.best_configuration(error)) for error in errors
        )
        thesis = tuple(row.thesis for row in compared)
        print_json(VisibilityOutput(site.name, found.beams, best, thesis, tuple(written)))
        return
    if not arguments.hit_beams:
        print_table(visibility.CONFIGURATIONS_TABLE, compared)
        for row in compared:
            if row.thesis.reason is not None:
                print(f"{to_plain_text(row.name)}: {console_text(row.thesis.reason)}")
        print(visibility.fewest_lines_text(found))
    print(f"{len(written)} files in {arguments.output}")
