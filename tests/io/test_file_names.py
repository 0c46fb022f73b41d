"""Tests of file names that are not UTF-8, and of terminals that cannot print a name."""

import errno
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, failure_reason
from lispac.messages import note
from lispac.survey.line_source import printable
from lispac.workflow.output.report_options import report_options
from tests.support.input_file_samples import START, fan, write_line, write_survey

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")


SEPARATOR = "then"
PROGRAM = f"""
import sys
from lispac.cli.main import main
words = sys.argv[1:]
while words:
    end = words.index({SEPARATOR!r})
    if main(words[:end]) != 0:
        sys.exit(1)
    words = words[end + 1 :]
"""
"""Runs several commands one after the other, which is faster than several programs."""


def run_lispac(*commands: list[object], **environment: str) -> subprocess.CompletedProcess[bytes]:
    words = [str(word) for command in commands for word in (*command, SEPARATOR)]
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, *map(os.fsencode, words)],
        capture_output=True, env={**os.environ, **environment}, check=False,
    )  # fmt: skip


def test_a_name_that_is_not_utf_8_is_shown_with_replacements() -> None:
    assert printable(os.fsdecode(b"l\xff1.laz")) == "l\ufffd1.laz"
    assert printable("Käi.laz") == "Käi.laz"
    assert (
        printable("a\ud800b\udfff.laz") == "a\ufffdb\ufffd.laz"
    )  # halves of surrogate pairs, not bytes


@pytest.mark.parametrize("encoding", ["ascii", pytest.param("utf-8", marks=pytest.mark.long)])
def test_any_name_can_be_printed_on_any_terminal(tmp_path: Path, encoding: str) -> None:
    folder = write_survey(tmp_path)
    first = folder / os.fsdecode(b"l\xff\xe9.las")
    write_line(folder / "plain.las", START + np.linspace(2, 12, 2000), fan(2000)).rename(first)
    second = folder / "Käi.las"
    write_line(second, START + np.linspace(15, 25, 2000), fan(2000))
    project = tmp_path / "project"
    environment = {"PYTHONIOENCODING": encoding, "PYTHONUTF8": "0"}
    done = run_lispac(
        ["inspect", first],
        ["new", project, first, second, "--trajectory", folder / "pos.sbet",
         "--trajectory-accuracy", folder / "smrmsg.out", "--lever-arm", 0.2, -0.1, 1.5],
        ["report", project, "--output", tmp_path / "report.json"],
        ["report", project, "--output", tmp_path / "report.html"],
        ["warnings", project],
        **environment,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    lines = json.loads((tmp_path / "report.json").read_text())["lines"]
    assert [line["name"] for line in lines] == ["l\ufffd\ufffd", "Käi"]


def test_the_reason_of_a_failure_does_not_contain_the_quoted_path(tmp_path: Path) -> None:
    """The text of an `OSError` has doubled backslashes."""
    path = tmp_path / "a\\b.las"
    with pytest.raises(OSError, match=r"b\.las") as raised:
        path.read_bytes()
    assert failure_reason(raised.value) == note("system.not_found")
    other = OSError(errno.EFAULT, "Bad address", str(path))
    assert failure_reason(other) == "Bad address"
    assert failure_reason(InputError(note("system.disk_full"))) == note("system.disk_full")
    assert failure_reason(ValueError("wrong")) == "wrong"
    assert failure_reason(MemoryError()) == "MemoryError"


def test_a_backslash_in_a_name_is_shown_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    template = tmp_path / "a\\b.toml"
    template.write_text("")

    def fail(path: Path) -> bytes:
        raise OSError(errno.EFAULT, "Bad address", str(path))

    monkeypatch.setattr(Path, "read_bytes", fail)
    with pytest.raises(InputError) as raised:
        report_options(template)
    assert "a\\b.toml" in str(raised.value)
    assert "\\\\" not in str(raised.value)
