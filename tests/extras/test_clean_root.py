"""Tests of the bundle and the README's commands on a minimal Debian (minutes; half an hour)."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
CAN_MAKE_ROOT = (
    sys.platform.startswith("linux") and os.geteuid() == 0 and shutil.which("debootstrap")
)


@pytest.mark.long
@pytest.mark.timeout(0)
@pytest.mark.skipif(not CAN_MAKE_ROOT, reason="needs root and debootstrap")
@pytest.mark.parametrize("what", ["bundle", "readme"])
def test_bundle_and_readme_on_a_minimal_system(what: str) -> None:
    command = [sys.executable, "-m", "tests.extras.clean_root", what]
    done = subprocess.run(command, cwd=CHECKOUT, check=False)
    assert done.returncode == 0
