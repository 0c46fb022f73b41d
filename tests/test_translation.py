"""The report in French: nothing of it stays English, and nothing of the user's is translated."""

import re
from pathlib import Path

import pytest

from lispac.errors import InputError
from lispac.io import sbet
from lispac.language import gettext, in_language
from lispac.message_texts import message_text
from lispac.report.settings_used import CONVENTION
from lispac.reverse_translation.catalogue import Catalogue, Template, catalogue_of, made, messages
from lispac.reverse_translation.translation import Translator
from tests.said import FRENCH, covered
from tests.told import told

ROOT = Path(__file__).resolve().parents[1] / "lispac"

RULES = r"""
[language]
thousands = "\u202F"
decimal = ","
conjunction = "et"
alternative = "ou"

[typography]
' :' = "\u00A0:"
"""
SMALL = {
    "north": "nord",
    "It has only {n:n} points.": "Elle n'a que {n} points.",
    "It has only 1 points.": "Elle n'a que 1 point.",
    "Good.": "Bonne.",
    "{target} on {line}: {reason}": "{target} sur {line} : {reason}",
    "{target} on {line}: no {what} there": "{target} sur {line} : pas de {what} ici",
    "Seen on {lines:list}.": "Vue sur {lines}.",
    "{line:name} ({n:n} mm)": "{line} ({n} mm)",
    "file {file:kept}": "fichier {file}",
    "north and south": "nord et sud",
    "Look {ways:either}.": "Regardez {ways}.",
    "Choose {codes:codes}.": "Choisissez {codes}.",
    "{file:file}: it is damaged ({why:foreign}).": "{file} : il est endommagé ({why}).",
    "disk full": "disque plein",
}


@pytest.fixture
def small() -> Catalogue:
    return made("xx", RULES, SMALL.items())


@pytest.mark.parametrize(
    ("english", "said"),
    [
        ("north", "nord"),
        ("1,234,567.8", "1\u202f234\u202f567.8"),
        ("+0.1000, 0.2000, 12", "+0.1000, 0.2000, 12"),
        ("It has only 1 points.", "Elle n'a que 1 point."),
        ("It has only 1,200 points.", "Elle n'a que 1\u202f200 points."),
        ("Good. It has only 7 points.", "Bonne. Elle n'a que 7 points."),
        ("It has\u00a0only 7 points.", "Elle n'a que 7 points."),
        ("T1 on L2: Good.", "T1 sur L2\u00a0: Bonne."),
        ("T1 on L2: It has only 7 points. Good.", "T1 sur L2\u00a0: Elle n'a que 7 points. Bonne."),
        ("T1 on L2: no north there", "T1 sur L2\u00a0: pas de nord ici"),
        ("Seen on L1, L2 (3.2 mm) and T1.", "Vue sur L1, L2 (3.2 mm) et T1."),
        ("file of and on.laz", "fichier of and on.laz"),
        ("Seen on north and south, L1.", "Vue sur nord et sud, L1."),
        ("Look north or north and south.", "Regardez nord ou nord et sud."),
        ("Choose north or x-y.", "Choisissez north ou x-y."),
        ("Choose north or x-y. Good.", "Choisissez north ou x-y. Bonne."),
        (
            "/d, e/St. Malo/a: it is damaged (no. 1: x).",
            "/d, e/St. Malo/a\u00a0: il est endommagé (no. 1: x).",
        ),
        ("a.las: it is damaged (disk full).", "a.las\u00a0: il est endommagé (disque plein)."),
        ("It is damaged (x).", "Il est endommagé (x)."),
        ("It has only 1e+07 points.", "Elle n'a que 1e+07 points."),
        ("\u2013", "\u2013"),
    ],
)
def test_texts_are_said(small: Catalogue, english: str, said: str) -> None:
    say = Translator(small, {"T1", "L1", "L2"})
    assert say(english) == said
    assert say.unknown == ()


def test_what_is_not_known_stays_and_is_counted(small: Catalogue) -> None:
    say = Translator(small, {"T1", "L1"})
    assert say("Nobody knows this.") == "Nobody knows this."
    assert say("Good. Nobody knows this.") == "Bonne. Nobody knows this."
    assert say("T1 on L1: nobody knows that") == "T1 sur L1\u00a0: nobody knows that"
    assert say("Seen on X.") == "Vue sur X."
    assert say.unknown == ("Nobody knows this.", "nobody knows that", "X")


@pytest.mark.timeout(20)  # all pieces tried, there were not hours enough
def test_many_sentences_that_nobody_knows_take_no_time(small: Catalogue) -> None:
    known = ["Good.", "It has only 7 points."] * 100
    english = " ".join(f"{each} Nobody knows sentence {k}." for k, each in enumerate(known))
    say = Translator(small)
    assert say(english).startswith("Bonne. Nobody knows sentence 0. Elle n'a que 7 points. Nobody")
    assert len(say.unknown) == 200


def test_numbers_are_written_as_the_language_does_where_that_is_wanted(small: Catalogue) -> None:
    say = Translator(small, {"v1.5"}, spoken_numbers=True)
    assert say("-1,234.50") == "-1\u202f234,50"
    assert say("It has only 1,200.5 points.") == "Elle n'a que 1\u202f200,5 points."
    assert say("v1.5 on v1.5: Good.") == "v1.5 sur v1.5\u00a0: Bonne."
    assert say("file a.1.2.laz") == "fichier a.1.2.laz"


def test_a_text_of_several_lines_is_said_where_one_entry_has_all_of_it() -> None:
    entries = {
        "north": "nord",
        "First row.\nSecond row.": "Première.\nSeconde.",
        "Facing {way}.\nPoints: {n:n}.": "Vers {way}.\nPoints : {n}.",
        "Line {line:name}.\nFacing {way}.": "Ligne {line}.\nVers {way}.",
        "Facing {way}.": "Vers {way}.",
    }
    say = Translator(made("xx", RULES, entries.items()), {"L1"})
    assert say.with_its_lines("First row.\nSecond row.") == "Première.\nSeconde."
    assert say.with_its_lines("Facing north.\nPoints: 1,200.") == (
        "Vers nord.\nPoints\u00a0: 1\u202f200."
    )
    assert say.with_its_lines("Line L1.\nFacing north.") == "Ligne L1.\nVers nord."
    # In part, of other rows, or by an entry whose place it cannot fill: each row is said alone.
    for english in (
        "Facing elsewhere.\nPoints: 7.", "Line L9.\nFacing north.", "Facing north.",
        "Facing north.\nPoints: 7.\nMore.", "Nobody knows.\nPoints: 7.", "First row.",
    ):  # fmt: skip
        assert say.with_its_lines(english) is None
    assert say.unknown == (), "the rows that are said alone are counted there"


def test_what_is_remembered_has_an_end(small: Catalogue, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lispac.reverse_translation.translation.MOST_KEPT", 3)
    say = Translator(small)
    for count in range(2, 12):
        assert say(f"It has only {count} points.") == f"Elle n'a que {count} points."
        assert len(say._said) <= 3
    assert say("Nobody knows this.") == say("Nobody knows this.") == "Nobody knows this."
    for count in range(2, 12):
        say(f"It has only {count} points.")
    assert say("Nobody knows this.") == "Nobody knows this."
    assert say.unknown == ("Nobody knows this.",)


def test_a_file_of_qt_linguist_is_read(tmp_path: Path) -> None:
    file = tmp_path / "xx.ts"
    file.write_text(
        """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context><name>words</name>
<message><source>it&apos;s</source><translation>c&apos;est</translation></message>
<message><source>new</source><translation type="unfinished"></translation></message>
<message><source>old</source><translation type="vanished">ancien</translation></message>
</context></TS>
""",
        encoding="utf-8",
    )
    assert list(messages(file)) == [("it's", "c'est")]


def test_a_name_that_is_a_word_is_not_translated(small: Catalogue) -> None:
    say = Translator(small, {"north", "Good."})
    assert say.cell("north") == "north"
    assert say("north on Good.: Good.") == "north sur Good.\u00a0: Good."
    assert say("north") == "nord", "a heading is no name"
    assert say.unknown == ()


def test_a_name_that_looks_like_a_list_stays(small: Catalogue) -> None:
    say = Translator(small, {"rock and roll", "a, b", "L1"})
    assert say("Seen on rock and roll, L1 and a, b.") == "Vue sur rock and roll, L1 et a, b."
    assert say("Seen on a, b and rock and roll.") == "Vue sur a, b et rock and roll."
    assert say("Seen on rock and roll.") == "Vue sur rock and roll."
    assert say.unknown == ()


def test_places_have_to_agree() -> None:
    for english, translation in (("{a} of {b}", "{a}"), ("{a}", "{b}"), ("{a} {a}", "{a}")):
        with pytest.raises(ValueError, match="differ"):
            Template(english, translation)
    with pytest.raises(ValueError, match="kind"):
        Template("{a:number}", "{a}")
    with pytest.raises(ValueError, match="twice"):
        made("xx", RULES, [*SMALL.items(), ("north", "nord")])
    with pytest.raises(InputError, match="'de'"):
        catalogue_of("de")


def test_french_is_set_as_french_is() -> None:
    for english, said in FRENCH.exact.items():
        bare = re.sub(r"\{\w+\}", "0", said)
        assert not re.search(r" [:;?!%»]|« |\d (mm|cm|m|s|ms)\b", bare), said
        assert not re.search(r"\b(the|of|and|is|are|that|with|by|its)\b", bare.split("«")[0]), said
        assert said.count("(") == said.count(")"), said
        assert english.strip() == english


def test_signs_are_those_of_the_convention() -> None:
    say = Translator(FRENCH)
    with in_language("fr"):
        said = gettext(CONVENTION)
    for words in (
        "Repère local\u00a0: nord, ouest, haut",
        "avant, gauche (bâbord), haut",
        "roulis est positif quand bâbord monte",
        "tangage est positif quand l’étrave descend",
        "lacet est positif dans le sens horaire vu d’en haut",
    ):
        assert words in said
    assert "Rz(−lacet)·Ry(tangage)·Rx(roulis)" in said.replace("\u200b", "")
    with in_language("fr"):
        applanix = message_text(sbet.ASSUMPTIONS[0])
    assert "roulis positif quand tribord descend, tangage positif quand l’étrave monte" in applanix
    assert say.unknown == ()


MODULES: dict[str, set[str] | None] = {
    **{
        f"report/{path.name}": None
        for path in (ROOT / "report").glob("*.py")
        if path.name != "control_charts.py"
        and not path.name.startswith(("visibility_", "design_", "field_plan"))  # not in a report
    },
    "adjustment/error_budget.py": None,
    "adjustment/crosscheck.py": None,
    "adjustment/solver.py": None,
    "adjustment/iteration.py": None,
    "design/advice.py": None,
    "targets/finder.py": None,
    "targets/lines.py": {"shifts_into"},
    "targets/across_lines.py": None,
    "targets/sphere_finder.py": None,
    "targets/spheres_across_lines.py": None,
    "geometry/planes.py": None,
    "geometry/spheres.py": None,
    "validation/reference_places.py": {"at_points"},
    "validation/comparison.py": None,
    "workflow/absolute.py": {"_too_few"},
    "survey/conventions/words.py": {"offsets_words"},
    "survey/conventions/conversion.py": {"assumption", "scanner_words", "angles_from"},
}
"""Where texts of the report are made; None for the whole module."""

NOT_SAID = {
    "worst direction",  # a key
    "Comparing 7 and 7 on 7",  # beside a progress bar
    # the window's and the command line's
    "not tested: with uncorrelated POS errors the sigmas are too small",
    "upper right", "outside right upper", "outside upper right", "offset points",  # matplotlib's
}  # fmt: skip
"""Strings of these modules that no report says."""


@pytest.mark.parametrize("module", MODULES)
def test_what_is_told_can_be_said_in_french(module: str) -> None:
    found = told(ROOT / module, MODULES[module])
    missing = [(line, text) for line, text in found if text not in NOT_SAID and not covered(text)]
    assert missing == []
