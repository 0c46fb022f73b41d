"""Types and common options of the command line arguments."""

import argparse
import math
import re
from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path

from lispac.cli.console import print_schema
from lispac.untrusted_values import MAX_AMOUNT, MIN_AMOUNT, is_possible_amount


def without_exponents(words: Sequence[str]) -> list[str]:
    """Replace ``-1e-3`` by ``-0.001``, since argparse would interpret it as an option."""
    return [
        f"{Decimal(word):f}" if re.fullmatch(r"-\d*\.?\d+[eE][+-]?\d{1,3}", word) else word
        for word in words
    ]


def split_named_value(text: str) -> tuple[str, str]:
    """Split ``NAME=VALUE`` into name and value.

    Raises
    ------
    ArgumentTypeError
        If the text does not have this form.
    """
    name, separator, value = text.partition("=")
    if not (name and separator):
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE")
    return name.strip(), value.strip()


def picture_file(text: str) -> Path:
    """Parse the path of a picture with a supported suffix.

    Raises
    ------
    ArgumentTypeError
        If the suffix is not supported.
    """
    path = Path(text)
    if path.suffix.lower() not in (".png", ".svg", ".pdf"):
        raise argparse.ArgumentTypeError(f"{text!r} does not end in .png, .svg or .pdf")
    return path


def add_json_option(parser: argparse.ArgumentParser) -> None:
    """Add the options ``--json`` and ``--schema``."""
    parser.add_argument(
        "--json", action="store_true", help="print the result as one JSON object on stdout"
    )
    parser.add_argument(
        "--schema", action=_SchemaAction, help="print the JSON schema of this object and exit"
    )


class _SchemaAction(argparse.Action):
    """Option that prints the schema of the command; other arguments are not required."""

    def __init__(self, option_strings: Sequence[str], dest: str, help: str) -> None:
        super().__init__(option_strings, argparse.SUPPRESS, nargs=0, help=help)

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        print_schema(parser.prog.split()[-1])
        parser.exit()


def add_triple_option(
    parser: argparse.ArgumentParser,
    name: str,
    parts: tuple[str, str, str],
    text: str,
    *,
    required: bool = False,
) -> None:
    """Add an option of three numbers."""
    parser.add_argument(
        name, type=finite_number, nargs=3, metavar=parts, help=text, required=required
    )


def add_crs_options(parser: argparse.ArgumentParser, default: str) -> None:
    """Add the options for a coordinate system, heights, datum and epoch."""
    parser.add_argument(
        "--crs", default="", metavar="CODE",
        help="coordinate system: EPSG code (EPSG:32619, EPSG:6347+5703) or WKT, or local for "
        f"North, West, Up (default {default})",
    )  # fmt: skip
    parser.add_argument(
        "--height", default="", metavar="WHAT",
        help="height reference: ellipsoid, EPSG code of a vertical system, or path of a geoid "
             "grid (default: from --crs, otherwise ellipsoid)",
    )  # fmt: skip
    parser.add_argument(
        "--trajectory-datum", metavar="CODE",
        help="geographic coordinate system of the trajectory if it differs from that of --crs, "
             "e.g. EPSG:7912 (default: as used when reading the lines; empty for no datum shift)",
    )  # fmt: skip
    parser.add_argument(
        "--epoch",
        type=finite_number,
        metavar="YEAR",
        help="epoch of the survey as a decimal year, for time-dependent datums (default: as used "
        "when reading the lines)",
    )


def finite_number(text: str) -> float:
    """Parse a finite number within the possible range.

    Raises
    ------
    ArgumentTypeError
        If the text is not such a number.
    """
    value = _parse_number(text)
    if not is_possible_amount(value):
        raise argparse.ArgumentTypeError(
            f"{text} is outside the possible range, {MIN_AMOUNT:g} to {MAX_AMOUNT:g}"
        )
    return value


def _parse_number(text: str) -> float:
    try:
        value = float(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text} is not a number") from error
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text} is not a finite number")
    return value


def positive_number(text: str) -> float:
    """Parse a number greater than zero.

    Raises
    ------
    ArgumentTypeError
        If the text is not such a number.
    """
    value = finite_number(text)
    if not value > 0:
        raise argparse.ArgumentTypeError(f"{text} is not larger than zero")
    return value


def number_within(low: float, high: float) -> Callable[[str], float]:
    """Return a function that parses a number between ``low`` and ``high``."""

    def number(text: str) -> float:
        value = _parse_number(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(
                f"{text} is outside the possible range, {low:g} to {high:,.0f}"
            )
        return value

    return number


def whole_number_from(low: int) -> Callable[[str], int]:
    """Return a function that parses an integer that is at least ``low``."""

    def number(text: str) -> int:
        try:
            value = int(text)
        except ValueError as error:
            raise argparse.ArgumentTypeError(f"{text} is not a whole number") from error
        if value < low:
            raise argparse.ArgumentTypeError(f"{text} is less than {low}")
        return value

    return number


def non_negative_number(text: str) -> float:
    """Parse a number that is zero or greater.

    Raises
    ------
    ArgumentTypeError
        If the text is not such a number.
    """
    value = finite_number(text)
    if not value >= 0:
        raise argparse.ArgumentTypeError(f"{text} is negative")
    return value
