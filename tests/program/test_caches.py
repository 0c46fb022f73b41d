"""Tests of the cache folder: choosing it, emptying it, and work without a writable home."""

import os
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

import pytest

from lispac import caches, installation_paths
from lispac.errors import InputError
from lispac.messages import error, note
from tests.support.long_runs import LONG


@pytest.fixture
def config(tmp_path: Path) -> Path:
    return tmp_path / "config"


def make_cache(place: Path) -> Path:
    """Make a cache with 35 bytes of the program among foreign files."""
    for name, size in (("matplotlib/fonts.json", 15), ("numba/a/k.nbc", 20)):
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_bytes(bytes(size))
    (place / "window.ini").write_bytes(bytes(7))
    (place / "thesis").mkdir()
    (place / "thesis" / "chapter.txt").write_text("mine")
    return place


def test_the_chosen_folder_is_stored_and_can_be_reset(config: Path, tmp_path: Path) -> None:
    assert caches.chosen_folder(config) is None
    assert caches.usable_cache_folder(config) == caches.default_folder() / "lispac"
    caches.choose_folder(tmp_path / "élan disk", config)
    assert not (
        tmp_path / "élan disk"
    ).exists()  # the check that the folder is writable leaves no file
    assert caches.usable_cache_folder(config) == tmp_path / "élan disk" / "lispac"
    caches.choose_folder(None, config)
    assert caches.chosen_folder(config) is None


def test_a_folder_that_is_not_writable_is_refused(config: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError) as refused:
        caches.choose_folder(tmp_path / "file", config)
    assert refused.value.message == error(
        "cache.folder_not_writable",
        folder=str(tmp_path / "file"),
        reason=note("system.not_a_folder"),
    )
    assert caches.chosen_folder(config) is None


def test_only_files_of_the_program_are_counted_and_removed(tmp_path: Path) -> None:
    place = make_cache(tmp_path / "lispac")
    assert caches.cache_size(place) == 35
    caches.empty_cache(place)
    assert caches.cache_size(place) == 0
    assert sorted(each.name for each in place.iterdir()) == ["thesis", "window.ini"]


def test_a_foreign_folder_called_manual_is_not_removed(tmp_path: Path) -> None:
    place = tmp_path / "lispac"
    (place / "manual").mkdir(parents=True)
    (place / "manual" / "tape.mp3").write_bytes(bytes(3))
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "kept").write_text("")
    (place / "numba").symlink_to(elsewhere)
    assert caches.cache_size(place) == 0
    caches.empty_cache(place)
    assert (place / "manual" / "tape.mp3").is_file()
    assert (elsewhere / "kept").is_file()


@pytest.mark.skipif(sys.platform != "linux", reason="the variables are those of Linux")
def test_the_command_line_uses_the_chosen_folder_unless_an_option_is_given(tmp_path: Path) -> None:
    config = tmp_path / "config"
    caches.choose_folder(tmp_path / "fast", config / "lispac")
    code = (
        "import os, sys; from lispac.cli.main import main; main(['sensors']); "
        "print(os.environ['NUMBA_CACHE_DIR'].split('/sources-')[0], os.environ['MPLCONFIGDIR'])"
    )
    variables = {k: v for k, v in os.environ.items() if k not in caches.CACHE_VARIABLES}
    variables |= {"XDG_CONFIG_HOME": str(config), "MPLCONFIGDIR": "/elsewhere"}
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=variables, check=True
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
def test_the_default_folder_is_that_of_the_system(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    system: str, variable: str, expected: tuple[str, ...],
) -> None:  # fmt: skip
    for name in ("LOCALAPPDATA", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    if variable:
        monkeypatch.setenv(variable, str(tmp_path / "local"))
    monkeypatch.setattr(Path, "home", lambda: tmp_path / "home")
    monkeypatch.setattr(caches.sys, "platform", system)
    assert caches.default_folder() == tmp_path.joinpath(*expected)


def test_choosing_the_same_folder_again_writes_nothing(config: Path, tmp_path: Path) -> None:
    (tmp_path / "fast").mkdir()
    caches.choose_folder(tmp_path / "fast", config)
    assert (tmp_path / "fast").is_dir()  # this place was already set before
    (config / caches.CHOSEN_FOLDER_FILE).chmod(0o444)
    before = (config / caches.CHOSEN_FOLDER_FILE).stat().st_ino
    caches.choose_folder(tmp_path / "fast", config)
    assert (config / caches.CHOSEN_FOLDER_FILE).stat().st_ino == before
    (config / caches.CHOSEN_FOLDER_FILE).chmod(0o644)


def test_a_manual_made_by_the_program_belongs_to_the_cache(tmp_path: Path) -> None:
    place = tmp_path / "lispac"
    (place / "manual").mkdir(parents=True)
    (place / "manual" / "index.html").write_bytes(bytes(9))
    assert caches.cache_size(place) == 0
    (place / "manual" / caches.MANUAL_MARKER_FILE).write_bytes(b"")
    assert caches.cache_size(place) == 9
    caches.empty_cache(place)
    assert not (place / "manual").exists()


def test_files_that_cannot_be_removed_are_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = make_cache(tmp_path / "lispac")

    def busy(part: Path) -> None:
        raise PermissionError(13, "in use", str(part))

    monkeypatch.setattr(caches.shutil, "rmtree", busy)
    with pytest.raises(InputError) as refused:
        caches.empty_cache(place)
    assert refused.value.message == error(
        "cache.not_removed", folder=str(place / "numba"), reason=note("system.permission")
    )


def environment_of(home: Path | str | None) -> dict[str, str]:
    """Variables of a process with this home directory and no other user folders."""
    own = (*caches.CACHE_VARIABLES, "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "HOME")
    variables = {name: value for name, value in os.environ.items() if name not in own}
    variables["PYTHONWARNINGS"] = "default"  # the program warns about these folders
    return variables if home is None else variables | {"HOME": str(home)}


def run_in_home(words: list[str], home: Path | str | None) -> subprocess.CompletedProcess[str]:
    """Run ``python -c ...`` with that home directory."""
    program = [sys.executable, *words]
    if os.geteuid() == 0 and shutil.which("setpriv"):  # permissions apply to root too
        own = "-dac_override"
        program = ["setpriv", "--bounding-set", own, "--inh-caps", own, *program]
    return subprocess.run(
        program, capture_output=True, text=True, env=environment_of(home), check=False
    )


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder for temporary files of processes started here."""
    folder = tmp_path / "tmp"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    return folder


UNWRITABLE_HOMES = ["a file", "missing", "below /proc", "read-only"]


@pytest.fixture
def no_home(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A home directory that is not writable, of the requested kind."""
    kind = request.param
    if kind == "a file":
        (tmp_path / "file").write_text("")
        return tmp_path / "file"
    if kind == "missing":
        return tmp_path / "missing"
    if kind == "below /proc":
        return Path("/proc/lispac-home")
    if os.geteuid() == 0 and not shutil.which("setpriv"):
        pytest.skip("root writes to read-only folders, and nothing here takes that from it")
    (tmp_path / "home").mkdir(mode=0o555)
    return tmp_path / "home"


linux = pytest.mark.skipif(sys.platform != "linux", reason="the variables are those of Linux")
MAKE_A_SURVEY = (
    "from lispac.cli.main import main; import os, sys; code = main(sys.argv[1:]); "
    "print(os.environ['NUMBA_CACHE_DIR'].split('/sources-')[0], os.environ['MPLCONFIGDIR']); "
    "sys.exit(code)"
)


@linux
@pytest.mark.parametrize("no_home", UNWRITABLE_HOMES, indirect=True)
def test_without_a_home_the_command_line_works_and_warns_once(
    no_home: Path, temporary: Path
) -> None:
    done = run_in_home(["-c", MAKE_A_SURVEY, "sensors", "--json"], no_home)
    assert done.returncode == 0, done.stderr
    assert [line[:5] for line in done.stderr.splitlines()] == ["note:"]
    assert f"{no_home / '.cache' / 'lispac'} cannot be written" in done.stderr
    places = [Path(word) for word in done.stdout.splitlines()[-1].split()]
    assert [place.name for place in places] == ["numba", "matplotlib"]
    assert all(place.is_relative_to(temporary) for place in places)
    (folder,) = temporary.iterdir()
    assert folder.stat().st_mode & 0o777 == 0o700
    assert not no_home.is_dir() or not any(no_home.iterdir())


@LONG
@linux
def test_compiled_code_is_reused_by_the_next_run_without_a_home(
    tmp_path: Path, temporary: Path
) -> None:
    words = ["-c", "import lispac; lispac.open; import lispac.survey.kernels as k; "
             "print(k.bounds_and_reach.stats.cache_path)"]  # fmt: skip
    first, second = (run_in_home(words, tmp_path / "missing") for _ in range(2))
    assert first.returncode == 0, first.stderr
    assert "cannot be written" in first.stderr
    assert Path(first.stdout.strip()).is_relative_to(temporary)
    assert second.stdout == first.stdout


@linux
def test_a_folder_that_others_can_write_to_is_not_used(tmp_path: Path, temporary: Path) -> None:
    open_folder = temporary / f"lispac-{os.getuid()}"
    open_folder.mkdir()
    open_folder.chmod(0o777)
    done = run_in_home(["-c", MAKE_A_SURVEY, "sensors"], tmp_path / "missing")
    assert done.returncode == 0, done.stderr
    assert not any(open_folder.iterdir())
    assert str(open_folder / "numba") not in done.stdout


@linux
def test_a_writable_home_gives_no_note(tmp_path: Path, temporary: Path) -> None:
    done = run_in_home(["-c", MAKE_A_SURVEY, "sensors"], tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.split()[-1] == str(tmp_path / ".cache" / "lispac" / "matplotlib")
    assert not any(temporary.iterdir())


@linux
def test_a_numba_folder_that_cannot_be_written_is_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    variables = {"NUMBA_CACHE_DIR": "/dev/null/numba", "MPLCONFIGDIR": str(tmp_path / "own")}
    message = caches.set_cache_variables(variables)
    assert message is not None
    assert message.code == "cache.not_writable"
    assert message.params["folder"] == "/dev/null/numba"
    assert variables == {
        "NUMBA_CACHE_DIR": str(tmp_path / "cache" / "lispac" / "numba"),
        "MPLCONFIGDIR": str(tmp_path / "own"),
    }


def test_an_account_without_a_home_has_a_temporary_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("LOCALAPPDATA", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", none)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    temporary_folder = cache(installation_paths.temporary_folder.__wrapped__)
    for module in (installation_paths, caches):
        monkeypatch.setattr(module, "temporary_folder", temporary_folder)
    assert installation_paths.user_folder().is_relative_to(tmp_path)
    assert caches.default_folder().is_relative_to(tmp_path)
    assert installation_paths.expand_user(Path("~nobody-of-this-name/x")) == Path(
        "~nobody-of-this-name/x"
    )
