"""Tests of the manual: links, both languages, building and caching."""

import re
import shutil
import sys
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from lispac.cli.parser import build_parser
from lispac.errors import Cancelled, InputError
from lispac.installation_paths import resource_path
from lispac.progress import Step
from lispac.workflow.output import manual
from tests.support.long_runs import LONG

LOADED_ATTRIBUTES = {("script", "src"), ("link", "href"), ("img", "src"), ("iframe", "src")}
"""Elements and attributes whose addresses a browser loads by itself."""


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """Return the sources of a manual of one page in each language."""
    sources = tmp_path / "sources"
    shutil.copytree(
        resource_path("manual"), sources, ignore=shutil.ignore_patterns("*.md", "*.png")
    )
    for language in ("en", "fr"):
        (sources / language).mkdir(exist_ok=True)
        (sources / language / "index.md").write_text("# One\n\nA page with $x^2$.\n")
    (sources / "en" / "mathematics.md").write_text("---\norphan: true\n---\n# Two\n")
    return sources


class _Reader(HTMLParser):
    """Collect the links, loaded files and anchors of a page."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.anchors: set[str] = set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if value is None:
                continue
            if name == "id":
                self.anchors.add(value)
            elif tag == "a" and name == "href":
                self.links.append(value)
            elif (tag, name) in LOADED_ATTRIBUTES:
                self.loads.append(value)


def test_links_have_targets_and_no_external_files_are_loaded(manual_pages: Path) -> None:
    read = {file: _Reader(file) for file in manual_pages.rglob("*.html")}
    for source in resource_path("manual").glob("*/*.md"):
        assert (
            manual_pages / source.relative_to(resource_path("manual")).with_suffix(".html") in read
        )
    for file, page in read.items():
        assert [each for each in page.loads if urlsplit(each).netloc] == [], file
        for link in [*page.loads, *page.links]:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            assert target.is_file(), f"{file.name} leads to {link}"
            if parts.fragment and target in read:
                known = read[target].anchors
                assert unquote(parts.fragment) in known, f"{file.name} leads to {link}"


def test_formulas_are_mathml(manual_pages: Path) -> None:
    assert "<math " in (manual_pages / "en" / "mathematics.html").read_text("utf-8")


def test_french_colons_have_no_break_spaces_and_pictures_are_links(manual_pages: Path) -> None:
    text = (manual_pages / "fr" / "tutorial.html").read_text("utf-8")
    assert "à la lettre\N{NO-BREAK SPACE}: noms" in " ".join(text.split("\n"))
    assert '<a class="reference internal" href="_images/start.png"><img ' in text


def test_the_navigation_of_a_french_page_is_french(manual_pages: Path) -> None:
    text = (manual_pages / "fr" / "report.html").read_text("utf-8")
    for french, english in (
        ("Suivant", "Next"),
        ("Précédent", "Previous"),
        ("Recherche", "Search"),
    ):
        assert french in text
        assert f">{english}<" not in text


def test_every_page_exists_in_both_languages() -> None:
    names = {
        language: {path.name for path in (resource_path("manual") / language).glob("*.md")}
        for language in ("en", "fr")
    }
    assert names["fr"] == names["en"]


def test_pages_have_the_same_structure_in_both_languages() -> None:
    for english in sorted((resource_path("manual") / "en").glob("*.md")):
        french = english.parents[1] / "fr" / english.name
        assert _parts(french) == _parts(english), english.name


def _parts(page: Path) -> Counter[str]:
    """Count the headings of each level, list items and table rows of a page."""
    found: Counter[str] = Counter()
    fenced = False
    for row in page.read_text("utf-8").splitlines():
        if row.startswith("```"):
            fenced = not fenced
        elif not fenced and (part := re.match(r"(#+) |-(?= )|\d+\.(?= )|\|", row)):
            found[part[1] or ("row" if part[0] == "|" else "item")] += 1
    return found


@pytest.mark.parametrize("language", ["en", "fr"])
def test_the_page_of_the_command_line_names_every_command(language: str) -> None:
    text = (resource_path("manual") / language / "commands.md").read_text("utf-8")
    commands = next(each.choices for each in build_parser()._actions if each.dest == "command")
    assert sorted(re.findall(r"^\| `([a-z][a-z-]*)` \|", text, re.MULTILINE)) == sorted(
        commands or ()
    )


@LONG
def test_the_manual_is_rebuilt_only_after_changes(small: Path, tmp_path: Path) -> None:
    place = tmp_path / "cache"
    first = manual.manual_page("fr", sources=small, place=place)
    assert first.is_file()
    assert first.parent.name == "fr"
    when = first.stat().st_mtime_ns
    assert manual.manual_page("fr", sources=small, place=place) == first
    assert first.stat().st_mtime_ns == when
    # A page that exists in English only
    english = manual.manual_page("fr", "mathematics", sources=small, place=place)
    assert english.parent.name == "en"
    (small / "fr" / "index.md").write_text("# Another\n")
    second = manual.manual_page("fr", sources=small, place=place)
    assert "Another" in second.read_text("utf-8")
    assert not first.exists()
    assert {each.name for each in place.iterdir()} == {"made-by-lispac", second.parents[1].name}


@LONG
def test_the_manual_is_built_with_a_locale_that_is_not_installed(
    small: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("LANG", "LC_ALL", "LC_TIME"):
        monkeypatch.setenv(name, "xx_XX.UTF-8")
    (small / "en" / "index.md").write_text("# Café\n", encoding="utf-8")
    page = manual.manual_page("en", sources=small, place=tmp_path / "cache")
    assert "Café" in page.read_text("utf-8")


def test_bundled_pages_are_not_built(small: Path, tmp_path: Path) -> None:
    (small / "html" / "en").mkdir(parents=True)
    (small / "html" / "en" / "index.html").write_text("shipped")
    page = manual.manual_page("en", sources=small, place=tmp_path / "cache")
    assert page.read_text() == "shipped"
    assert not (tmp_path / "cache").exists()


def test_a_missing_builder_is_reported(
    small: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(manual.BUILD_PACKAGES, "no_such_module", "Sphinx of tomorrow")
    with pytest.raises(InputError) as refused:
        manual.manual_page("en", sources=small, place=tmp_path / "cache")
    assert refused.value.code == "manual.not_installed"
    assert refused.value.message is not None
    assert refused.value.message.params == {
        "count": 1, "packages": ["Sphinx of tomorrow"], "folder": str(small)
    }  # fmt: skip
    assert [each.name for each in (tmp_path / "cache").iterdir()] == ["made-by-lispac"]


@LONG
def test_errors_of_the_builder_are_reported_and_leave_no_pages(small: Path, tmp_path: Path) -> None:
    (small / "en" / "index.md").write_text("# One\n\n![gone](gone.png)\n")
    with pytest.raises(InputError, match=r"gone\.png"):
        manual.build_manual(small, tmp_path / "out", strict=True)
    (small / "conf.py").write_text("raise RuntimeError('no way')\n")
    with pytest.raises(InputError, match="no way"):
        manual.manual_page("en", sources=small, place=tmp_path / "cache")
    assert [each.name for each in (tmp_path / "cache").iterdir()] == ["made-by-lispac"]


def test_a_cancelled_build_leaves_no_pages(small: Path, tmp_path: Path) -> None:
    def stop(fraction: float, step: Step | None = None) -> None:
        if fraction == 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        manual.manual_page("en", sources=small, place=tmp_path / "cache", progress=stop)
    assert [each.name for each in (tmp_path / "cache").iterdir()] == ["made-by-lispac"]


@pytest.mark.skipif(sys.platform == "win32", reason="a folder below a file is another error there")
def test_a_folder_that_is_not_writable_is_reported(small: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError) as raised:
        manual.manual_page("en", sources=small, place=tmp_path / "file" / "manual")
    assert raised.value.code == "manual.not_writable"
