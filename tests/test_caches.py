"""The place of the cache: chosen once for window and command line, and emptied of ours alone."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from lispac import caches
from lispac.errors import InputError


@pytest.fixture
def config(tmp_path: Path) -> Path:
    return tmp_path / "config"


def filled(place: Path) -> Path:
    """A cache with 35 bytes of ours among what is not."""
    for name, size in (("demo/raw/demo", 5), ("demo/raw/L1.laz", 10), ("numba/a/k.nbc", 20)):
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_bytes(bytes(size))
    (place / "window.ini").write_bytes(bytes(7))
    (place / "thesis").mkdir()
    (place / "thesis" / "chapter.txt").write_text("mine")
    return place


def test_the_choice_is_kept_and_taken_back(config: Path, tmp_path: Path) -> None:
    assert caches.chosen_folder(config) is None
    assert caches.cache_place(config) == caches.usual_folder() / "lispac"
    caches.choose(tmp_path / "élan disk", config)
    assert caches.cache_place(config) == tmp_path / "élan disk" / "lispac"
    assert not (tmp_path / "élan disk").exists()  # nothing is left of the trial
    caches.choose(None, config)
    assert caches.chosen_folder(config) is None


def test_a_place_that_cannot_be_written_is_refused_in_a_sentence(
    config: Path, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError) as refused:
        caches.choose(tmp_path / "file", config)
    assert str(refused.value) == (
        f"{tmp_path / 'file'}: the cache cannot be written there (Not a directory); choose another "
        "folder."
    )
    assert caches.chosen_folder(config) is None


def test_only_what_is_ours_is_counted_and_removed(tmp_path: Path) -> None:
    place = filled(tmp_path / "lispac")
    assert caches.size(place) == 35
    caches.empty(place)
    assert caches.size(place) == 0
    assert sorted(each.name for each in place.iterdir()) == ["thesis", "window.ini"]


def test_a_folder_called_demo_that_is_not_ours_stays(tmp_path: Path) -> None:
    place = tmp_path / "lispac"
    (place / "demo").mkdir(parents=True)
    (place / "demo" / "tape.mp3").write_bytes(bytes(3))
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "kept").write_text("")
    (place / "numba").symlink_to(elsewhere)
    assert caches.size(place) == 0
    caches.empty(place)
    assert (place / "demo" / "tape.mp3").is_file()
    assert (elsewhere / "kept").is_file()


@pytest.mark.skipif(sys.platform != "linux", reason="the variables are those of Linux")
def test_the_command_line_follows_the_choice_unless_told_otherwise(tmp_path: Path) -> None:
    config = tmp_path / "config"
    caches.choose(tmp_path / "fast", config / "lispac")
    told = (
        "import os, sys; from lispac.cli.main import main; main(['sensors']); "
        "print(os.environ['NUMBA_CACHE_DIR'], os.environ['MPLCONFIGDIR'])"
    )
    variables = {k: v for k, v in os.environ.items() if k not in caches.VARIABLES}
    variables |= {"XDG_CONFIG_HOME": str(config), "MPLCONFIGDIR": "/elsewhere"}
    done = subprocess.run(
        [sys.executable, "-c", told], capture_output=True, text=True, env=variables, check=True
    )
    assert done.stdout.splitlines()[-1] == f"{tmp_path / 'fast' / 'lispac' / 'numba'} /elsewhere"


@pytest.mark.parametrize(
    ("system", "variable", "expected"),
    [
        ("win32", "LOCALAPPDATA", ("local", "cache")),
        ("win32", "", ("home", "AppData", "Local", "cache")),
        ("darwin", "XDG_CACHE_HOME", ("home", "Library", "Caches")),
        ("linux", "XDG_CACHE_HOME", ("local",)),
        ("linux", "", ("home", ".cache")),
    ],
)
def test_the_usual_folder_is_that_of_the_system(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    system: str, variable: str, expected: tuple[str, ...],
) -> None:  # fmt: skip
    for name in ("LOCALAPPDATA", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    if variable:
        monkeypatch.setenv(variable, str(tmp_path / "local"))
    monkeypatch.setattr(Path, "home", lambda: tmp_path / "home")
    monkeypatch.setattr(caches.sys, "platform", system)
    assert caches.usual_folder() == tmp_path.joinpath(*expected)


def test_choosing_the_same_again_writes_nothing(config: Path, tmp_path: Path) -> None:
    (tmp_path / "fast").mkdir()
    caches.choose(tmp_path / "fast", config)
    assert (tmp_path / "fast").is_dir()  # it was there before
    (config / caches.CHOICE).chmod(0o444)
    before = (config / caches.CHOICE).stat().st_ino
    caches.choose(tmp_path / "fast", config)
    assert (config / caches.CHOICE).stat().st_ino == before
    (config / caches.CHOICE).chmod(0o644)


def test_a_manual_that_we_made_is_ours(tmp_path: Path) -> None:
    place = tmp_path / "lispac"
    (place / "manual").mkdir(parents=True)
    (place / "manual" / "index.html").write_bytes(bytes(9))
    assert caches.size(place) == 0
    (place / "manual" / caches.MANUAL_MARK).write_bytes(b"")
    assert caches.size(place) == 9
    caches.empty(place)
    assert not (place / "manual").exists()


def test_what_cannot_be_removed_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    place = filled(tmp_path / "lispac")

    def busy(part: Path) -> None:
        raise PermissionError(13, "in use", str(part))

    monkeypatch.setattr(caches.shutil, "rmtree", busy)
    with pytest.raises(InputError) as refused:
        caches.empty(place)
    assert str(refused.value) == (
        f"{place / 'numba'}: cannot be removed (in use); close other programs that may use it and "
        "try again."
    )
