"""Errors, notes and remarks of the core in French: each that it can make has a translation."""

import re
from itertools import chain
from pathlib import Path

import pytest

from lispac.language.translation import Translator
from tests.said import FRENCH, covered
from tests.test_bad_input import rows
from tests.told import told

ROOT = Path(__file__).resolve().parents[1] / "lispac"
MODULES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in ROOT.rglob("*.py")
    if path.relative_to(ROOT).parts[0] not in ("gui", "cli")
)

NOT_SAID: dict[str, set[str]] = {
    "regular expressions": {
        "(bow|nose) up|up (bow|nose)",
        "(bow|nose) down|down (bow|nose)",
        "POS Export Utility|Applanix|POSPac|POSPROC",
        r"([A-Za-z][A-Za-z ,]*?)\s+in\s+([A-Za-z./]+(?:\s+(?:Min\w*|Survey \w+|Feet|Foot))?)",
        r"; import (it|the line) again\.$",
        "[^.:;{}]*(?:, | and | or )[^.:;{}]*",
    },
    "names of columns, and words of the headers of other programs, as they are looked for": {
        "time latitude longitude height roll pitch heading",
        "time gpstime utctime timestamp seconds sec tow sow gpstow secondsofweek timesec",
        "date day",
        "latitude lat",
        "longitude lon long lng",
        "height ellipsoidheight ellipsoidalheight hell hgt heightell h z ellht",
        "altitude alt elevation orthoheight orthometricheight msl orthheight hmsl",
        "heading yaw azimuth hdg trueheading",
        "easting east x e",
        "northing north y n",
        "northsd northingsd latitudesd latsd sdnorth latitudestd northstd",
        "eastsd eastingsd longitudesd lonsd longsd sdeast longitudestd eaststd",
        "heightsd altitudesd ellipsoidheightsd upsd downsd sdheight heightstd altitudestd",
        "rollsd sdroll rollstd",
        "pitchsd sdpitch pitchstd",
        "headingsd sdheading headingstd yawsd",
        "Date of Mission",
        "Mapping frame datum",
        "POSPROC SBET file",
        "(time in",
        "position sd",
        "laszip encoded",
    },
    "comments of files that other programs and the command line read": {
        "# A plan. Along the wall to the right as seen from the water, off it towards the water,",
        "# up from the vessel's POS; from_level_deg 90 is upright, less leans back.",
        "# Trajectory written by LISPAC.",
        "# Time as in the source; latitude and longitude in degrees, height in metres above the "
        "ellipsoid;",
        "# roll positive starboard down, pitch positive bow up, heading clockwise from true north, "
        "in degrees (Applanix).",
        "Built-in survey; remade by every run of the demo.\n",
        "Simulated survey; remade by every run of the simulation into it.\n",
    },
    "the tables beside the figures of a study of visibility, and the command line's of them": {
        "Visibility on the 7 site",
        "Best configurations on the 7 site",
        "The choice of table 3.2 lies near the board that faces the beams (-20 deg here), where a "
        "roll error moves points along it. Appendix C.2.1 names -40 and then 30 deg for the same "
        "figure; 30 is the upper end of what it keeps, and so is the best here",
        "With the scanner along the body axes this offset is a roll, to the last digit; the thesis "
        "has -40 deg for the one, -50 for the other, and 30 in appendix C.2.7, where the error is "
        "1 and not 2 deg",
        "Table 3.2 chooses an inclination that appendix C.2.6 does not keep (-40 to 10 deg). At "
        "-60 deg parallel and diagonal lines meet the board at nearly equal angles, so that the "
        "offset shifts both alike",
        "A board that leans back shows roll more than an upright one, since beams climb to it by "
        "18 deg; the thesis considers 0 to 90 deg only, and of these the upright one is best here "
        "too",
        "7 mm and 7 deg at 7 deg",
        "Why is not known",
        "7. The lines differ by 7.",
    },
    "options of the command line, said as they are typed": {"--trajectory-option time=7"},
    "names in a simulated scene": {
        "tower leg", "tower base", "tower cabin", "south quay",
        "7, north face", "7, east face", "7, south face", "7, west face",
    },
    "names of other programs": {
        "NovAtel Inertial Explorer, SPAN",
        "PDAL filters.georeference (scan2imu)",
        "StripAlign (NED attitude, *)",
        "RIEGL RiPROCESS",
    },
    "the language of PROJ": {
        "+step +proj=unitconvert +xy_in=deg +xy_out=rad",
        '+step +proj=vgridshift +grids="7" +multiplier=1',
        "+step +proj=unitconvert +xy_in=rad +xy_out=deg",
    },
    "words of matplotlib": {
        "upper right", "axes fraction", "offset points", "outside upper right",
        "outside right upper", "outside lower center",
    },
    "keys, and the name of a thread": {
        "worst direction", "taken over", "at need", "reading ahead",
    },
    "a mistake of a programmer": {"a column of numbers has a header of one fixed size"},
}  # fmt: skip
"""Strings that nobody is shown, or that are shown as they are, by the reason."""
UNSAID = set(chain.from_iterable(NOT_SAID.values()))


@pytest.mark.parametrize("module", MODULES)
def test_what_the_core_tells_can_be_said_in_french(module: str) -> None:
    found = told(ROOT / module, at_once=True)
    assert [(line, text) for line, text in found if text not in UNSAID and not covered(text)] == []


def test_what_is_not_said_is_there_and_not_translated() -> None:
    there = {text for module in MODULES for _, text in told(ROOT / module, at_once=True)}
    assert {text for text in UNSAID if text not in there or covered(text)} == set()


@pytest.mark.parametrize("folder", ["", "/home/anne/St. Malo/quay, east/", "C:\\Levés\\quai\\"])
def test_what_is_said_of_bad_input_is_said_in_french_whole(folder: str) -> None:
    """The sentences of the manual's table are those of the program: `test_bad_input`."""
    say = Translator(FRENCH, spoken_numbers=True)
    for english, _, _ in rows().values():
        placed = re.sub(r"^(?=[\w/]+(\.\w+)[:,] )", lambda _: folder, english)
        said = say(placed)
        assert said != placed
        if placed != english:
            assert said.startswith(folder)
    assert say.unknown == ()


@pytest.mark.parametrize(
    ("english", "said"),
    [
        (
            "/d/L1.las: cannot be written (No space left on device); make room on the disk or "
            "choose another folder.",
            "/d/L1.las\u00a0: écriture impossible (le disque est plein)\u202f; faites de la place "
            "sur le disque ou choisissez un autre dossier.",
        ),
        (
            "/d/L1.las: cannot be read as LAS or LAZ (Invalid file signature. b'x': no LASF); copy "
            "or export it again.",
            "/d/L1.las\u00a0: illisible comme LAS ou LAZ (Invalid file signature. b'x': no LASF)"
            "\u202f; copiez-le ou exportez-le de nouveau.",
        ),
        (
            "About 4.0 % of the points lie before or after the trajectory and about 2.5 % of the "
            "points lie in a gap of the trajectory longer than 1 s: these points will be left out.",
            "Environ 4,0\u00a0% des points sont avant ou après la trajectoire et environ "
            "2,5\u00a0% des points sont dans une lacune de la trajectoire de plus de 1\u00a0s"
            "\u00a0: ces points seront laissés de côté.",
        ),
        (
            "Times from 1 to 7.5 s fit no known time base; check which column or record is the "
            "time.",
            "Des temps de 1 à 7,5\u00a0s ne conviennent à aucune base de temps connue\u202f; "
            "vérifiez quelle colonne ou quel champ est le temps.",
        ),
        (
            "The times are taken as GPS seconds of the day; by their values alone they could also "
            "be GPS seconds of the week or UTC seconds since 1970-01-01.",
            "Base de temps supposée\u00a0: secondes GPS du jour. D’après leurs seules valeurs, les "
            "temps pourraient aussi être secondes GPS de la semaine ou secondes UTC depuis le "
            "1970-01-01.",
        ),
        (
            "/d/plan.toml: boards[2].height_m is 'tall'; give one of low, high.",
            "/d/plan.toml\u00a0: boards[2].height_m vaut 'tall'\u202f; donnez l’un de ces mots"
            "\u00a0: low, high.",
        ),
    ],
)
def test_what_errors_hold_is_in_its_place(english: str, said: str) -> None:
    say = Translator(FRENCH, spoken_numbers=True)
    assert say(english) == said
    assert say.unknown == ()
