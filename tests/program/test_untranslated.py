"""Test that all shown texts of the program are in the translation catalogues."""

import re
from itertools import chain
from pathlib import Path

import pytest

from lispac.io.trajectory.trajectory_columns import ROLES_BY_COLUMN_NAME
from tests.support.french_catalogue import FRENCH
from tests.support.source_texts import displayed_texts

ROOT = Path(__file__).resolve().parents[2] / "lispac"
ENGLISH_ONLY = {"cli", "scripting", "gui/window/program.py", "workflow/output/batch.py"}
"""Modules with English texts: the command line and the interface for scripts."""
MODULES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in ROOT.rglob("*.py")
    if not path.relative_to(ROOT).as_posix().startswith(tuple(ENGLISH_ONLY))
)

NOT_SHOWN: dict[str, set[str]] = {
    "regular expressions": {
        "([A-Za-z][A-Za-z ,]*?)\\s+in\\s+([A-Za-z./]+(?:\\s+(?:Min\\w*|Survey \\w+|Feet|Foot))?)",
        "(bow|nose) down|down (bow|nose)",
        "(bow|nose) up|up (bow|nose)",
        "POS Export Utility|Applanix|POSPac|POSPROC",
    },
    "comments of files that other programs and the command line read": {
        "# A plan. Along the wall to the right as seen from the water, off it towards the water,",
        "# Trajectory written by LISPAC.",
        "# roll positive starboard down, pitch positive bow up, heading clockwise from "
        "true north, in degrees (Applanix).",
        "# up from the vessel's POS; inclination_deg 90 is upright, less leans back.",
        "Built-in survey; each run of the demo replaces it.\n",
        "Simulated survey; each simulation replaces it.\n",
        "This file opens the LISPAC project in its folder.\n",
    },
    "the script of a project, and what its comments say, which is Python with English names": {
        "Run it with the Python in which LISPAC is installed: python SCRIPT FOLDER creates "
        "the project in FOLDER, python SCRIPT in the folder named below.",
        "Steps of the project 7, as LISPAC 7 wrote them.",
        "folder = Path(sys.argv[1] if len(sys.argv) > 1 else 7-again)",
        "from pathlib import Path",
        "its points were edited manually",
        "the search from its seed now gives other points, because it was found with other lines "
        "or another prior boresight, or proposed automatically",
    },
    "names of other programs": {
        "Applanix POS MV, LVX, POSPac",
        "NovAtel Inertial Explorer, SPAN",
        "PDAL filters.georeference (scan2imu)",
    },
    "the language of PROJ": {
        '+proj=vgridshift +grids="7" +multiplier=1',
    },
    "a mistake of a programmer": {
        "a column of numbers has a header of one fixed size",
    },
    "help of the command line": {
        "company of the surveyor",
        "number of the report",
        "revision of the report",
        "client of the calibration",
        "number of the contract or order",
        "person who processed the data",
        "person who checked the result",
        "reference frame of the trajectory, e.g. NAD83(CSRS)v7",
        "epoch of the coordinates, e.g. 2010.0",
        "GNSS base station or correction service",
        "program and version that computed the trajectory",
        "dates of the survey, e.g. 2026-03-04",
        "origin of the lever arm, e.g. total station survey in dock, 2026-03-04",
        "maker and model of the INS/GNSS",
        "maker and model of the LiDAR",
        "name of the vessel",
        "serial number of the INS/GNSS",
        "serial number of the LiDAR",
        "other information for the reader of the report",
        "name of the survey site",
        "person responsible for the calibration",
    },
    "keys": {
        "text of a static scan",
    },
    "errors of a programmer, and a label that is in French in every language": {
        "7 does not say how it shows a result",
        "line 7 is hidden and cannot be clicked",
        "the last chunk is damaged",
        "the mouse does not point now",
    },
}
"""Strings that nobody is shown, or that are shown as they are, by the reason."""
UNTRANSLATED = set(chain.from_iterable(NOT_SHOWN.values()))
_WORD = re.compile(r"[^\W\d_]{2,}")
_TAG = re.compile(r"<[^>]*>")
_MIN_WORDS = 4
"""Words of a text; shorter strings may be keys."""


def _literals(module: str) -> list[tuple[int, str]]:
    """Return line and text of strings that may be shown.

    Style sheets, bare tags and lists of column names of other programs are left out.
    """
    return [
        (line, text)
        for line, text in displayed_texts(ROOT / module, at_once=True)
        if not text.rstrip().endswith((";", "}"))
        and len(_WORD.findall(_TAG.sub("", text))) >= _MIN_WORDS
        and not ROLES_BY_COLUMN_NAME.keys() >= set(text.split())
    ]


@pytest.mark.parametrize("module", MODULES)
def test_shown_texts_are_in_the_catalogues(module: str) -> None:
    assert [each for each in _literals(module) if each[1] not in UNTRANSLATED | {*FRENCH}] == []


def test_french_texts_have_one_kind_of_space_before_a_sign() -> None:
    """A no-break space before colons and percent signs, a narrow one before ; ! and ?."""
    wrong = re.compile("[ \u202f][:%»]|[ \u00a0][;!?]|«[ \u202f]|[0-9]e centile")
    assert [text for text in FRENCH.values() if wrong.search(text)] == []


def test_the_list_of_untranslated_strings_is_complete() -> None:
    there = {text for module in MODULES for _, text in _literals(module)}
    assert there >= UNTRANSLATED
