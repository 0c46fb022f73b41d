"""Tests of the developer documents: links, mentioned files and names, and size."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DEVELOPERS = ROOT / "resources" / "developers"
PAGES = sorted(DEVELOPERS.rglob("*.md"))
DOCUMENTS = [ROOT / "CONTRIBUTING.md", ROOT / "README.md", *PAGES]
DECISIONS = sorted((DEVELOPERS / "decisions").glob("[0-9]*.md"))
PLACEHOLDERS = re.compile(r"[*<>]|NAME|VERSION|NNN|FOLDER|test_x\.py")
"""Parts of paths that stand for any file."""


def title_of(page: Path) -> str:
    """First heading of a page."""
    return page.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ")


def links(text: str) -> list[str]:
    """Relative links of a page in Markdown."""
    found = re.findall(r"\]\(([^)\s]+)\)", text)
    return [link for link in found if "://" not in link and not link.startswith("#")]


def mentioned_files(text: str) -> list[tuple[str, str]]:
    """Files in backticks, with the name after ``::``, or an empty one."""
    found = re.findall(r"`([\w./-]+\.(?:py|md|toml|txt|typ|j2|po))(?:::([\w.]+))?`", text)
    return [each for each in found if not PLACEHOLDERS.search(each[0])]


def located(path: str) -> Path | None:
    """Path of a file given relative to the repository or to the package."""
    return next((each for each in (ROOT / path, ROOT / "lispac" / path) if each.is_file()), None)


@cache
def names_in(path: Path) -> frozenset[str]:
    """Names defined by a module; names in classes are qualified by the class."""
    found: set[str] = set()

    def collect(body: list[ast.stmt], prefix: str) -> None:
        for node in body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                found.add(prefix + node.name)
            if isinstance(node, ast.ClassDef):
                collect(node.body, f"{node.name}.")
            targets = node.targets if isinstance(node, ast.Assign) else []
            targets = [node.target] if isinstance(node, ast.AnnAssign) else targets
            for target in targets:
                found.update(
                    prefix + each.id for each in ast.walk(target) if isinstance(each, ast.Name)
                )

    collect(ast.parse(path.read_text(encoding="utf-8")).body, "")
    return frozenset(found)


@pytest.mark.parametrize("page", DOCUMENTS, ids=lambda page: page.name)
def test_links_lead_to_existing_files(page: Path) -> None:
    for link in links(page.read_text(encoding="utf-8")):
        assert (page.parent / link.partition("#")[0]).exists(), link


@pytest.mark.parametrize("page", DOCUMENTS, ids=lambda page: page.name)
def test_mentioned_files_and_names_exist(page: Path) -> None:
    for path, name in mentioned_files(page.read_text(encoding="utf-8")):
        file = located(path)
        assert file is not None, path
        assert not name or name in names_in(file), f"{path}::{name}"


def test_missing_files_and_names_are_found() -> None:
    text = "`survey/cloud.py::Cloud`, `survey/cloud.py::Cloud.within`, `survey/no.py`, `io/NAME.py`"
    assert mentioned_files(text) == [
        ("survey/cloud.py", "Cloud"), ("survey/cloud.py", "Cloud.within"), ("survey/no.py", ""),
    ]  # fmt: skip
    assert located("survey/no.py") is None
    cloud = located("survey/cloud.py")
    assert cloud is not None
    assert {"Cloud", "Cloud.within", "MAX_REGION_POINTS"} <= names_in(cloud)
    assert "Cloud.without" not in names_in(cloud)
    assert links("[a](b.md#c), [d](https://e.org), [f](#g)") == ["b.md#c"]


@pytest.mark.parametrize("page", DECISIONS, ids=lambda page: page.name)
def test_a_decision_is_one_page_with_all_sections(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert title_of(page).startswith(f"{page.name[:3]}. ")
    headings = re.findall(r"^## (.+)$", text, re.MULTILINE)
    assert headings in (
        ["Context", "Decision", "Consequences"], ["Context", "Decision", "Consequences", "Measured"]
    )  # fmt: skip
    assert text.count("\n") <= 70


def test_the_indexes_list_every_page() -> None:
    decisions = DEVELOPERS / "decisions" / "index.md"
    text = decisions.read_text(encoding="utf-8")
    for page in DECISIONS:
        assert f"- [{title_of(page)}]({page.name})\n" in text
    listed = links(text) + links((DEVELOPERS / "index.md").read_text(encoding="utf-8"))
    assert {Path(link).name for link in listed} == {page.name for page in PAGES}
    assert [int(page.name[:3]) for page in DECISIONS] == sorted(
        {int(page.name[:3]) for page in DECISIONS}
    )


def test_the_first_documents_are_short() -> None:
    assert (ROOT / "CONTRIBUTING.md").stat().st_size <= 8192
    assert (ROOT / "README.md").read_text(encoding="utf-8").count("\n") <= 60
