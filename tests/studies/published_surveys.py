"""Calibration of the published drone surveys by each method, compared with their reference.

    python -m tests.studies.published_surveys FOLDER

`FOLDER` contains `lanl_truck` and `lanl_tent`. A row for each survey and method (seeds on labelled
planes, targets proposed by the program, targetless adjustment): the deviation of each angle from
the reference, the same divided by its standard deviation, and the serious warnings.
"""

import json
import sys
from collections.abc import Sequence
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.main import main as run_command
from lispac.workflow.project.projects import open_project, save_project

SURVEYS = ("lanl_truck", "lanl_tent")
METHODS = ("seeds", "proposed", "targetless")
SIGMAS = (
    "--position-sigma", "0.02", "0.02", "0.02", "--attitude-sigma", "0.015", "0.015", "0.015",
    "--lidar-sigma", "0.02",
)  # fmt: skip
"""Accuracies in the metadata of the surveys."""


def command(*words: object) -> dict[str, Any]:
    """Run a command with ``--json``, and return the object that it prints.

    Raises
    ------
    RuntimeError
        The command refuses; the text is its error.
    """
    out, errors = StringIO(), StringIO()
    with redirect_stdout(out), redirect_stderr(errors):
        code = run_command([*map(str, words), "--json"])
    if code:
        raise RuntimeError(errors.getvalue().strip())
    return json.loads(out.getvalue())


def calibrated(data: Path, method: str, project: Path) -> dict[str, Any]:
    """Result of one survey with one method."""
    site = json.loads((data / "site.json").read_text())
    command(
        "new", project, "--trajectory", data / "trajectory.sbet", "--lever-arm",
        *site["lever_arm_m"], "--origin", *site["origin_deg_m"], *SIGMAS,
        *sorted(data.glob("*.laz")),
    )  # fmt: skip
    if method == "targetless":
        return command("targetless", project)
    if method == "proposed":
        command("propose", project, "--accept")
    else:
        seeds = project.parent / "seeds.txt"
        rows = site["seeds_nwu_on_line1"].items()
        seeds.write_text("".join(f"{name} {x} {y} {z}\n" for name, (x, y, z) in rows))
        command("pick", project, "--seeds", seeds, "--role", "target")
        opened = open_project(project)
        for target in opened.targets:
            if len(target.sightings) < 2:
                opened = opened.without_target(target.name)
        save_project(opened)
    return command("estimate", project)


def angles(values: dict[str, float]) -> np.ndarray:
    return np.array([values[angle] for angle in ANGLES])


def row(data: Path, method: str) -> str:
    """Row of the table."""
    reference = json.loads((data / "reference.json").read_text())
    with TemporaryDirectory() as folder:
        try:
            found = calibrated(data, method, Path(folder, "project"))
        except RuntimeError as refusal:
            return f"{data.name:10s}  {method:10s}  refused: {refusal}"
    off = angles(found["boresight_deg"]) - reference["boresight_deg"]
    ratio = off / np.hypot(angles(found["sigma_deg"]), reference["repeatability_deg"])
    serious = sorted(each["code"] for each in found["warnings"] if each["level"] == "warning")

    def cells(values: Sequence[float] | np.ndarray, digits: int) -> str:
        return " ".join(f"{value:+8.{digits}f}" for value in values)

    return f"{data.name:10s}  {method:10s}  {cells(off, 4)}   {cells(ratio, 2)}   {serious}"


def main() -> None:
    """Print the table."""
    print(f"{'survey':10s}  {'method':10s}  {'deviation, deg':26s}   {'in sigma':26s}   warnings")
    for survey in SURVEYS:
        for method in METHODS:
            print(row(Path(sys.argv[1]) / survey, method), flush=True)


if __name__ == "__main__":
    main()
