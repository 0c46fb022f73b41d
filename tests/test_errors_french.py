"""Errors, notes and remarks of the core in French: each that it can make has a translation."""

import re
from itertools import chain
from pathlib import Path

import pytest

from lispac.reverse_translation.translation import Translator
from tests.said import FRENCH, covered
from tests.test_bad_input import rows
from tests.told import told

ROOT = Path(__file__).resolve().parents[1] / "lispac"
MODULES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in ROOT.rglob("*.py")
    if path.relative_to(ROOT).parts[0] not in ("gui", "cli", "scripting")
)
"""Those of all rooms whose texts the window shows: a script is told of its errors in English."""

NOT_SAID: dict[str, set[str]] = {
    "regular expressions": {
        "(bow|nose) up|up (bow|nose)",
        "(bow|nose) down|down (bow|nose)",
        "POS Export Utility|Applanix|POSPac|POSPROC",
        r"([A-Za-z][A-Za-z ,]*?)\s+in\s+([A-Za-z./]+(?:\s+(?:Min\w*|Survey \w+|Feet|Foot))?)",
        "[^.:;{}]*(?:, | and | or )[^.:;{}]*",
    },
    "names of columns, and words of the headers of other programs, as they are looked for": {
        "time latitude longitude height roll pitch heading",
        "slant range",
        "horizontal angle",
        "vertical angle",
        "latitudehemisphere ns northsouth lathemisphere lathemi latdir latns",
        "longitudehemisphere ew eastwest lonhemisphere lonhemi londir lonew we eo oe estouest ow "
        "wo ostwest",
        "time gpstime utctime timestamp seconds sec tow sow gpstow secondsofweek timesec zeit "
        "temps",
        "date day",
        "latitude lat breite latitudes lats",
        "longitude lon long lng laenge länge longitudew lonw longitudewest lonwest westlongitude",
        "height ellipsoidheight ellipsoidalheight hell hgt heightell h z ellht höhe hoehe hauteur "
        "altitudeellipsoid ellipsoidaltitude ellipsoidalaltitude altitudeellipsoidal",
        "roll roulis",
        "pitch tangage",
        "seaheight altitude alt elevation orthoheight orthometricheight msl orthheight hmsl",
        "heading yaw azimuth hdg trueheading cap",
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
        "This file opens the LISPAC project in its folder.\n",
        "# A plan. Along the wall to the right as seen from the water, off it towards the water,",
        "# up from the vessel's POS; from_level_deg 90 is upright, less leans back.",
        "# Trajectory written by LISPAC.",
        " Time base: ",
        "# Time as in the source; latitude and longitude in degrees, height in metres above the "
        "ellipsoid;",
        "# roll positive starboard down, pitch positive bow up, heading clockwise from true north, "
        "in degrees (Applanix).",
        "Built-in survey; each run of the demo replaces it.\n",
        "Simulated survey; each simulation replaces it.\n",
    },
    "the script of a project, and what its comments say, which is Python with English names": {
        "folder / 7.json",
        "folder / 7.pdf",
        "Steps of the project 7, as LISPAC 7 wrote them.",
        "Run it with the Python that LISPAC is installed in: python SCRIPT FOLDER makes the "
        "project in that folder, python SCRIPT in the one named below.",
        "import sys",
        "from pathlib import Path",
        "import lispac",
        "folder = Path(sys.argv[1] if len(sys.argv) > 1 else 7-again)",
        "data = Path(7)",
        "points of it were added or taken away by hand",
        "its seed leads to other points now: it was found with other lines, another prior "
        "boresight, or proposed",
    },
    "options of the command line, said as they are typed": {"--trajectory-option time=7"},
    "names in a simulated scene": {
        "tower leg", "tower base", "tower cabin", "south quay",
        "7, north face", "7, east face", "7, south face", "7, west face",
    },
    "the language of PROJ": {'+proj=vgridshift +grids="7" +multiplier=1'},
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
    """The sentences of the manual's table are those of the program: `test_bad_input`.

    It checks typed messages, which the reverse translation does not know, in French too.
    """
    for english, _, _ in rows().values():
        say = Translator(FRENCH, spoken_numbers=True)
        placed = re.sub(r"^(?=[\w/]+(\.\w+)[:,] )", lambda _: folder, english)
        said = say(placed)
        if say.unknown:  # a typed message
            continue
        assert said != placed
        if placed != english:
            assert said.startswith(folder)


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


COMPOSED = [
    "L1.las: 5 points outside the trajectory's time and 3 points in gaps of the trajectory or "
    "where its pitch is beyond 80 deg, of 1,000, are left out",
    "T1 shares points with T2: 40 % of its points on L1 are the same. Keep one of the two: they "
    "would count twice.",
    "T1 is the surface of T2 already: 40 % of the points of T2 on L1 are the same. Keep one of the "
    "two.",
    "Seen on 6 lines; without it the sigma of yaw would be 0.120° instead of 0.030°.",
    "Plane of 2.3 m², seen on 6 lines, opposite ones among them, 3 m high. Poor on L1: Its RMS of "
    "12 mm is 4 times the noise: it is rough or not flat.",
    "quay: only 1 flat surface is seen on two lines or more (2 more are not flat, 1 more is seen "
    "poorly); set seeds on the targets, put up boards, or use the targetless method.",
    "The scanner looks 2.00 deg bow down, is turned 0.40 deg to starboard and leans 0.50 deg with "
    "its left side up.",
    "The scanner's optical centre is 0.186 m aft of, 0.038 m to port of and 2.419 m above the POS "
    "centre.",
    "/p/quay: the disk is full; make room (about 3.1 GB while importing) or move the project to a "
    "larger disk, then import the line again.",
    "L1.las: No point lies within the trajectory: the line is 1.0 to 2.0 s, the trajectory 5.0 to "
    "6.0 s, 3 s before it starts. (2 more files have errors.)",
    "Times restart at the end of the week (after 604,799.994 s): counted on by 604800 s.",
    "+18.000 s are added to its times, from UTC seconds of the week (stated) to the trajectory's "
    "GPS seconds of the week (as its values suggest), with the leap seconds of today, 18 s, as "
    "neither tells the date; +19.000 s would fit as well: make sure of the day.",
    "Points in GPS seconds of the day fit the trajectory in GPS seconds of the week after adding "
    "432,000.000 s, with 100 % of the points inside it; by the times alone a further shift of "
    "+18.000 s (UTC seconds of the day) or +86,400.000 s (GPS seconds of the day) fits as well: "
    "state the time base of the points (option time_base).",
    "Line 2 (L3) was not sailed: with it the sigma of yaw would be 0.0100 instead of 0.0200 deg.",
    "quay differs from those before it (roll by +0.1000 deg, 3.2 of its sigmas): the mounting has "
    "moved, or one of the calibrations is wrong. A new series begins.",
    "Left out: quay: it has no date; lispac identity quay --dates, or Details for the report, "
    "gives it one.",
]
"""What several functions make together, as `told` sees the parts of alone."""


@pytest.mark.parametrize("english", COMPOSED)
def test_what_is_put_together_is_said_whole(english: str) -> None:
    say = Translator(FRENCH, {"T1", "T2", "L1", "L3", "quay"}, spoken_numbers=True)
    assert say(english) != english
    assert say.unknown == ()
