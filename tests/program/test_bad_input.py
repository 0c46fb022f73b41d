"""Tests that each row of the manual's table of bad input gives the documented message."""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path

import pytest

from lispac.cli import main as command_line
from lispac.cli.main import main
from lispac.errors import LispacError
from lispac.language import in_language
from lispac.language import to_plain_text as console_text
from tests.support.bad_files import REFUSED, WITH_WARNING, Scene
from tests.support.bad_places import ACTIONS
from tests.support.long_runs import others_long

Run = Callable[[Sequence[str] | None], None]
MANUAL = Path(__file__).resolve().parents[2] / "resources" / "manual"
ACTION = (
    r"copy|export|choose|check|give|leave|state|clean|make room|say which|sort|bring|move|add|name"
    r"|restore|import|exclude"
)


@pytest.fixture
def scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Scene]:
    """A valid survey."""
    with ExitStack() as stack:
        yield Scene(tmp_path, monkeypatch, stack)


def content_of_folder(scene: Scene) -> dict[str, bytes | None]:
    """Content of each file and folder, without those that the case itself changes."""
    return {
        str(path.relative_to(scene.folder)): path.read_bytes() if path.is_file() else None
        for path in sorted(scene.folder.rglob("*"))
        if path.name not in scene.changed_files
    }


def rows(language: str = "en") -> dict[str, tuple[str, str, str]]:
    """Rows of the table by their problem: message, action and remaining data."""
    found: dict[str, tuple[str, str, str]] = {}
    heads = ("Problem", "Problème")
    for line in (MANUAL / language / "bad-input.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == 4 and not set(cells[0]) <= set("-: ") and cells[0] not in heads:
            assert cells[0] not in found, cells[0]
            found[cells[0]] = (cells[1], cells[2], cells[3])
    return found


def test_the_table_has_a_row_for_every_case_and_no_other() -> None:
    assert set(rows()) == {*REFUSED, *WITH_WARNING}
    assert not set(REFUSED) & set(WITH_WARNING)
    assert all(all(cells) for cells in rows().values())


def test_the_french_actions_have_the_same_commands_as_the_english_ones() -> None:
    english = list(rows().values())
    page = list(rows("fr").values())
    for (_, do, _), (_, action, _) in zip(page, english, strict=True):
        typed = re.findall("`[^`]+`", action.replace("FILE", "FICHIER"))
        assert re.findall("`[^`]+`", do) == typed


@pytest.mark.parametrize("name", REFUSED)
def test_bad_input_is_refused_with_the_documented_message(
    scene: Scene, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    words = REFUSED[name](scene)
    before = content_of_folder(scene)
    capsys.readouterr()
    errors: list[LispacError] = []

    def recorded(argv: Sequence[str] | None = None, run: Run = command_line.run) -> None:
        try:
            run(argv)
        except LispacError as failure:
            errors.append(failure)
            raise

    monkeypatch.setattr(command_line, "run", recorded)
    assert main(words) == 1
    out, err = capsys.readouterr()
    assert out == ""
    line, rest = err.split("\n")
    assert rest == ""
    assert line.startswith("lispac: ")
    line = re.sub(r"(?<=\.) \([^()]*\)$", "", line)  # a suggested option
    assert line.endswith(".")
    assert re.search(ACTION, line, re.IGNORECASE)
    assert content_of_folder(scene) == before, "something was changed or left"
    refusal = line.removeprefix("lispac: ").replace(f"{scene.folder}/", "")
    assert refusal == rows()[name][0]
    (failure,) = errors
    assert failure.code
    with in_language("fr"):
        french = str(failure).replace(f"{scene.folder}/", "")
    assert french == rows("fr")[french_heads()[name]][0]


def french_heads() -> dict[str, str]:
    """Problem in the French table, by the problem in the English one."""
    return dict(zip(rows(), rows("fr"), strict=True))


def shown_messages(shown: str) -> list[str]:
    """Warnings and notes of an output."""
    return list(map(plain, re.findall(r"^ *(?:warning|note): (.*)$", shown, re.MULTILINE)))


def plain(text: str) -> str:
    """The text with plain spaces, as a terminal shows it."""
    return re.sub("[\u00a0\u202f]", " ", text)


@pytest.mark.parametrize("language", others_long(["en", "fr"]))
@pytest.mark.parametrize("name", WITH_WARNING)
def test_bad_input_gives_the_documented_warning(
    scene: Scene, capsys: pytest.CaptureFixture[str], name: str, language: str
) -> None:
    words = WITH_WARNING[name](scene)
    row = rows(language)[name if language == "en" else french_heads()[name]]
    expected = {plain(row[0]), plain(console_text(row[0]))}
    before = content_of_folder(scene)
    capsys.readouterr()
    with in_language(language):
        assert main(words) == 0
    out, err = capsys.readouterr()
    shown = out if words[0] == "inspect" else err
    assert expected & set(shown_messages(shown))
    after = content_of_folder(scene)
    assert before.items() <= after.items()
    if words[0] == "inspect":
        assert after == before
        with in_language(language):
            assert main(scene.new()) == 0
        assert expected & set(shown_messages(capsys.readouterr().err))


@pytest.mark.parametrize("name", ACTIONS)
def test_the_documented_action_works(
    scene: Scene, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    assert f"`{ACTIONS[name]}`" in rows()[name][1]
    words = REFUSED[name](scene)
    assert main([*words, *ACTIONS[name].split()]) == 0, capsys.readouterr().err
