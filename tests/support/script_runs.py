"""Run scripts like a user, and compare their reports."""

import json
import os
import runpy
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]


def run(script: str, folder: Path) -> dict[str, Any]:
    """Run the script of a project without a display and read its report.

    Parameters
    ----------
    folder : for the project that it makes; must not exist
    """
    path = _written(script, folder)
    variables = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run(
        [sys.executable, "-W", "error", str(path), str(folder)], capture_output=True, text=True,
        check=False, env={**variables, "PYTHONPATH": str(CHECKOUT)}, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return _script_result(folder)


def run_in_process(script: str, folder: Path) -> dict[str, Any]:
    """As `run`, in this process, which has already imported the modules, so that it is faster."""
    path = _written(script, folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", [str(path), str(folder)])
        runpy.run_path(str(path), run_name="__main__")
    return _script_result(folder)


def _written(script: str, folder: Path) -> Path:
    path = folder.parent / "script.py"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(script, encoding="utf-8")
    return path


def _script_result(folder: Path) -> dict[str, Any]:
    (written,) = (file for file in folder.glob("*.json") if file.name != "project.json")
    return same_part(written)


def same_part(report: Path) -> dict[str, Any]:
    """A report in JSON without its date and the name of the folder."""
    content = json.loads(report.read_text(encoding="utf-8"))
    del content["generated"], content["project"]
    return content  # type: ignore[no-any-return]
