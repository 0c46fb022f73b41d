"""Tests of the progress line of commands and of their end after errors and interrupts."""

import io
import runpy
import sys
from pathlib import Path

import pytest

from lispac.cli import main as entry
from lispac.cli.console import ConsoleProgress, has_display
from lispac.cli.main import main
from lispac.cli.planning import sensors
from lispac.errors import Cancelled
from tests.support.command_errors import command_error


class Terminal(io.StringIO):
    """Text stream that claims to be a terminal."""

    def isatty(self) -> bool:
        return True


def test_progress_is_one_line_that_is_cleared(monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Terminal()
    monkeypatch.setattr(sys, "stderr", screen)
    now = 100.0
    monkeypatch.setattr("time.monotonic", lambda: now)
    with ConsoleProgress() as progress:
        progress(0.05, "Reading the lines")
        progress(0.06, "too soon to be drawn")
        now += 0.2
        progress(0.5, "Done")
    first = "  5% Reading the lines"
    # The shorter text is padded to cover the longer one, and the line is blank at the end.
    second = " 50% Done"
    assert screen.getvalue() == (f"\r{first}\r{second.ljust(len(first))}\r{' ' * len(second)}\r")


def test_progress_is_not_written_to_a_file(monkeypatch: pytest.MonkeyPatch) -> None:
    log = io.StringIO()
    monkeypatch.setattr(sys, "stderr", log)
    with ConsoleProgress() as progress:
        progress(0.5, "Reading the lines")
    assert log.getvalue() == ""


@pytest.mark.parametrize(
    ("platform", "variables", "there"),
    [
        ("linux", {}, False),
        ("linux", {"DISPLAY": ":0"}, True),
        ("linux", {"WAYLAND_DISPLAY": "wayland-0"}, True),
        ("win32", {}, True),
        ("darwin", {}, True),
    ],
)
def test_a_window_needs_a_display_on_linux_only(
    monkeypatch: pytest.MonkeyPatch, platform: str, variables: dict[str, str], there: bool
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert has_display() is there


SUGGESTED_CHECK = "Check the path, the disk and the permissions."


@pytest.mark.parametrize(
    ("error", "printed"),
    [
        (MemoryError(), "lispac: not enough memory; use shorter lines.\n"),
        (KeyboardInterrupt(), "lispac: interrupted.\n"),
        (Cancelled(), "lispac: interrupted.\n"),
        (OSError(28, "No space left on device", "/d/a.laz"),
         f"lispac: /d/a.laz: No space left on device. {SUGGESTED_CHECK}\n"),
        (OSError("gone"), f"lispac: a file: gone. {SUGGESTED_CHECK}\n"),
        (BrokenPipeError(), ""),  # the reader of the output has closed it
    ],
)  # fmt: skip
def test_an_error_or_interrupt_is_printed_as_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    error: BaseException, printed: str,
) -> None:  # fmt: skip
    def stop(_: object) -> None:
        raise error

    monkeypatch.setattr(sensors, "run", stop)
    assert main(["sensors"]) == 1
    assert capsys.readouterr() == ("", printed)


def test_the_module_can_be_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    none = tmp_path / "none"
    monkeypatch.setattr(sys, "argv", ["lispac", "compare", str(none)])
    with pytest.raises(SystemExit) as ended:
        runpy.run_path(str(entry.__file__), run_name="__main__")
    assert ended.value.code == 1
    refusal = command_error("compare", none)
    assert refusal.code == "project.not_found"
    assert capsys.readouterr().err == f"lispac: {refusal}\n"
