"""Translations: extract the English texts, bring the catalogues up to date, compile them.

    python installer/catalogues.py update [--take FILE.po ...]
    python installer/catalogues.py check

`update` writes ``resources/i18n/CODE/LC_MESSAGES/lispac.po`` and ``lispac.mo``: new texts get an
empty translation, which FILE.po may supply, and removed texts are deleted. `check` returns exit
code 1 if a text has no translation, its placeholders differ, or a file is out of date. The compiled
files are committed, so that a checkout runs without a build.
"""

import argparse
import ast
import re
import sys
from datetime import UTC, datetime
from io import BytesIO
from pathlib import Path
from string import Formatter

from babel.messages.catalog import Catalog, Message
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

ROOT = Path(__file__).resolve().parents[1]
LANGUAGE_CODES = ("fr",)
MARKING_FUNCTIONS = {"N_": None, "gettext": None, "gettext_lazy": None, "Plural": (1, 2)}
"""Functions whose arguments are texts to translate, with the positions of singular and plural; None
for a single text."""

TYPOGRAPHY = (
    ("'", "\u2019"),
    ("[ \u00a0\u202f]+([:»%])", "\u00a0\\1"),
    ("[ \u00a0\u202f]+([;!?])", "\u202f\\1"),
    ("«[ \u202f]", "«\u00a0"),
    (r"([\d}]) (mm|cm|m|km|s|ms|h|Hz)\b(?!['\u2019])", "\\1\u00a0\\2"),
)
"""French typography: regular expressions and their replacements in a translation."""

CATALOGUE_DATE = datetime(2026, 1, 1, tzinfo=UTC)
"""Fixed date in all catalogues, so that a file changes only if its texts change."""

FILE_HEADER = "# Translations of LISPAC; installer/catalogues.py brings this file up to date."


def path_of(code: str) -> Path:
    """Path of the editable catalogue (.po) of a language."""
    return ROOT / "resources" / "i18n" / code / "LC_MESSAGES" / "lispac.po"


def extracted() -> Catalog:
    """Catalogue of the English texts of the program, with the file of each text."""
    found = Catalog(project="LISPAC", charset="utf-8")
    for file, _, text, comments, _ in extract_from_dir(ROOT / "lispac", keywords=MARKING_FUNCTIONS):
        if text:
            place = f"lispac/{Path(file).as_posix()}"
            # Line numbers are omitted: they would change with every edit.
            found.add(text, locations=[(place, 0)], auto_comments=comments)
    return found


def not_extracted(catalogue: Catalog) -> list[str]:
    """Texts marked in the source that Babel does not find, for example in an f-string."""
    found = []
    for path in sorted((ROOT / "lispac").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
                continue
            if node.func.id not in MARKING_FUNCTIONS or not node.args:
                continue
            first = node.args[0]
            text = first.value if isinstance(first, ast.Constant) else None
            if isinstance(text, str) and text and text not in catalogue:
                found.append(f"not extracted from {path.relative_to(ROOT)}: {text!r}")
    return found


def updated(code: str, take: list[Path]) -> Catalog:
    """Catalogue of a language with the present texts of the program.

    Parameters
    ----------
    take : catalogue files whose translations replace those of the catalogue
    """
    catalogue = read(path_of(code))
    catalogue.update(extracted(), no_fuzzy_matching=True)
    catalogue.obsolete.clear()
    for path in take:
        supplied = read(path)
        for message in catalogue:
            other = supplied.get(message.id) if message.id else None
            if other is not None and is_translated(other):
                message.string = other.string
    for message in catalogue:
        message.flags.discard("python-format")
        if message.id and message.string:
            strings = tuple(map(typeset, strings_of(message)))
            message.string = strings if isinstance(message.id, tuple) else strings[0]
    return catalogue


def read(path: Path) -> Catalog:
    """Read a catalogue from a file; an empty French one if the file is missing."""
    if not path.exists():
        return Catalog(locale="fr")
    with path.open("rb") as file:
        return read_po(file, locale="fr")


def typeset(text: str) -> str:
    """Replace apostrophes and spaces in a translation as French typography requires."""
    for pattern, replacement in TYPOGRAPHY:
        text = re.sub(pattern, replacement, text)
    return text


def strings_of(message: Message) -> tuple[str, ...]:
    """The translation of a text, or those of its singular and plural."""
    return (message.string,) if isinstance(message.string, str) else tuple(message.string or ())


def is_translated(message: Message) -> bool:
    """Whether a text and its plural have translations."""
    return bool(strings_of(message)) and all(strings_of(message))


def problems(catalogue: Catalog) -> list[str]:
    """Texts without a translation, and translations with other placeholders."""
    found = []
    for message in catalogue:
        if not message.id:
            continue
        english = message.id if isinstance(message.id, str) else tuple(message.id)[1]
        if not is_translated(message):
            found.append(f"no translation: {english!r}")
            continue
        for string in strings_of(message):
            # The singular may omit the count.
            if places(string) != places(english) and places(string) | {"count"} != places(english):
                found.append(f"other placeholders: {english!r}")
    return found


def places(text: str) -> set[str]:
    """Names of the placeholders of a text."""
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def written(catalogue: Catalog) -> tuple[bytes, bytes]:
    """Contents of the .po and the .mo file."""
    catalogue.creation_date = catalogue.revision_date = CATALOGUE_DATE
    catalogue.project, catalogue.header_comment, catalogue.fuzzy = "LISPAC", FILE_HEADER, False
    catalogue.copyright_holder = catalogue.last_translator = catalogue.language_team = "LISPAC"
    catalogue.msgid_bugs_address = ""
    po, mo = BytesIO(), BytesIO()
    write_po(po, catalogue, width=100, sort_by_file=True, omit_header=False, include_lineno=False)
    write_mo(mo, catalogue)
    return po.getvalue(), mo.getvalue()


def main(argv: list[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("command", choices=("update", "check"))
    parser.add_argument("--take", nargs="+", type=Path, default=[], metavar="FILE.po")
    arguments = parser.parse_args(argv)
    failed = False
    for code in LANGUAGE_CODES:
        catalogue = updated(code, arguments.take)
        po, mo = written(catalogue)
        files = {path_of(code): po, path_of(code).with_suffix(".mo"): mo}
        if arguments.command == "update":
            for path, content in files.items():
                path.write_bytes(content)
        outdated = [path for path, content in files.items() if path.read_bytes() != content]
        found = [f"out of date: {path.relative_to(ROOT)}" for path in outdated]
        found += problems(catalogue) + not_extracted(catalogue)
        print("\n".join(f"{code}: {each}" for each in found) or f"{code}: up to date")
        failed = failed or bool(found)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
