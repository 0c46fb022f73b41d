"""Tests that file names cannot send control sequences to the terminal."""

import io
import sys
from pathlib import Path

import pytest

from lispac.cli.main import main


class Terminal(io.TextIOWrapper):
    """Stream that claims to be a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize("terminal", [True, False])
def test_control_characters_of_names_are_escaped_on_a_terminal(
    terminal: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    bytes_ = io.BytesIO()
    stream = (Terminal if terminal else io.TextIOWrapper)(bytes_, encoding="utf-8")
    monkeypatch.setattr(sys, "stderr", stream)
    assert main(["inspect", str(tmp_path / "a\x1b[31m\u202eb.laz")]) == 1
    stream.flush()
    shown = bytes_.getvalue().decode()
    assert "\x1b" not in shown
    assert ("\\u202eb.laz" in shown) == terminal
    assert ("\u202eb.laz" in shown) != terminal
