"""Tests of the paths of the program's files and of the user folder."""

import sys
from pathlib import Path

import pytest

from lispac.errors import InputError
from lispac.installation_paths import resource_path, user_folder, window_command
from lispac.messages import error


def test_a_missing_file_of_the_installation_is_reported() -> None:
    assert resource_path("manual").is_dir()
    with pytest.raises(InputError) as refused:
        resource_path("manual/no-such-page.md")
    assert refused.value.message == error(
        "installation.file_missing", name="manual/no-such-page.md"
    )


@pytest.mark.parametrize(
    ("platform", "variable", "place"),
    [
        ("win32", "LOCALAPPDATA", "AppData/Local/lispac"),
        ("darwin", "", "Library/Preferences/lispac"),
        ("linux", "XDG_CONFIG_HOME", ".config/lispac"),
    ],
)
def test_the_user_folder_follows_the_operating_system(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, platform: str, variable: str, place: str
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    for name in ("LOCALAPPDATA", "XDG_CONFIG_HOME"):
        monkeypatch.delenv(name, raising=False)
    assert user_folder() == tmp_path / place
    if variable:
        monkeypatch.setenv(variable, str(tmp_path / "chosen"))
        assert user_folder() == tmp_path / "chosen" / "lispac"


def test_the_window_command_of_the_bundle(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert window_command() == [sys.executable, "-m", "lispac.gui"]
    monkeypatch.setattr(sys, "executable", str(tmp_path / "lispac.exe"))
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert window_command() == [str(tmp_path / "lispac-gui.exe")]
