"""The bundle and the README's commands on a Debian that has nothing; minutes, and half an hour."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
ABLE = sys.platform.startswith("linux") and os.geteuid() == 0 and shutil.which("debootstrap")


@pytest.mark.long
@pytest.mark.timeout(0)
@pytest.mark.skipif(not ABLE, reason="needs root and debootstrap")
@pytest.mark.parametrize("what", ["bundle", "readme"])
def test_from_nothing_to_done(what: str) -> None:
    command = [sys.executable, "-m", "tests.extras.clean_root", what]
    done = subprocess.run(command, cwd=CHECKOUT, check=False)
    assert done.returncode == 0
