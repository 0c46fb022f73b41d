"""What takes too long for every run: one command, a log for each step, and a table at the end.

    python -m tests.extras.nightly FOLDER                     all of it, most of a night
    python -m tests.extras.nightly FOLDER coverage long       these steps

`coverage` and `mutation` need `python -m pip install coverage mutmut` in the environment; `bundle`
and `readme` need root and debootstrap (`tests.extras.clean_root`). Exit 1 where a step failed.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
PYTEST = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
LEAST = 95.0
"""Percent of the core's branches that the tests take."""
ROOMS = {
    "geometry": (
        "frames", "planes", "rotations", "spheres", "conventions", "convention_rules",
        "repeatability", "crs", "hidden", "normal_distance", "cloud_distance", "sections",
        "spheres_adjusted", "sphere_finder", "vessel_adjustment", "georeferencing",
    ),
    "adjustment": (
        "adjustment", "averaging", "doubts", "error_budget", "invariance", "observability",
        "omitted", "parameters", "prediction", "reliability", "robustness", "shown",
        "spheres_adjusted", "standards", "variance_factor", "vessel_adjustment",
    ),
    "survey": (
        "cidco_states", "cloud", "clouds", "conventions", "convention_present",
        "convention_rules", "convention_words", "crs", "crs_operation", "frame_stated",
        "georeferencing", "georeferencing_map", "recovery", "scanners", "time_base",
        "time_restart", "time_stated", "trajectory_quality",
    ),
}  # fmt: skip
"""Rooms whose code is changed to see which test notices, and the tests that are quick enough."""
COMPILED = ("lispac/geometry/knn.py", "lispac/survey/kernels.py")
"""Modules of machine code: a change would be compiled anew in every run."""
ANSWERED = Path(__file__).with_name("survivors.toml")
"""By the line that a change puts in place of ours: why no test has to notice it."""

Log = Path
Step = Callable[[Path, Log], str]
"""Does one thing in a folder, writes to a log, and says what it found; raises `Failed`."""


class Failed(Exception):
    """A step did not end as it has to; the message says how."""


def run(command: Sequence[str], log: Log, **environment: str) -> None:
    """Run a command in the checkout; its output goes to the end of the log."""
    with log.open("a", encoding="utf-8") as file:
        file.write(f"$ {' '.join(command)}\n")
        file.flush()
        done = subprocess.run(
            command, cwd=CHECKOUT, stdout=file, stderr=subprocess.STDOUT, check=False,
            env=os.environ | environment,
        )  # fmt: skip
    if done.returncode:
        raise Failed(f"exit {done.returncode}; see {log}")


def long(_folder: Path, log: Log) -> str:
    """Tests marked long, one after the other: the monkey's ten minutes measure pauses."""
    run([*PYTEST, "-m", "long", "-n", "0", "--timeout=0", "--ignore", "tests/extras"], log)
    return re.findall(r"\d+ passed.*", log.read_text(encoding="utf-8"))[-1]


def coverage(folder: Path, log: Log) -> str:
    """Branches of the core that the normal run takes."""
    settings = f"--rcfile={Path(__file__).with_name('coverage.ini')}"
    data = {"COVERAGE_FILE": str(folder / "coverage")}
    measure = [sys.executable, "-m", "coverage"]
    # Followed line by line everything takes twice as long
    run([*measure, "run", settings, "-m", *PYTEST[2:], "--timeout=1800"], log, **data)
    run([*measure, "combine", settings], log, **data)
    run([*measure, "json", settings, "-o", str(folder / "coverage.json")], log, **data)
    totals = json.loads((folder / "coverage.json").read_text(encoding="utf-8"))["totals"]
    share = 100.0 * totals["covered_branches"] / totals["num_branches"]
    said = f"{share:.1f} % of {totals['num_branches']} branches of the core"
    if share < LEAST:
        raise Failed(f"{said}, less than {LEAST:.0f} %; see {folder / 'coverage.json'}")
    return said


def mutation(folder: Path, log: Log) -> str:
    """Changes of geometry, adjustment and survey that no test notices and nobody has answered."""
    answered = tomllib.loads(ANSWERED.read_text(encoding="utf-8"))
    told, open_ = [], []
    for room, tests in ROOMS.items():
        place = folder / f"mutation-{room}"
        shutil.rmtree(place, ignore_errors=True)
        run(["git", "clone", "-q", str(CHECKOUT), str(place)], log)
        (place / "setup.cfg").write_text(_settings(room, tests), encoding="utf-8")
        mutmut = [sys.executable, "-m", "mutmut"]
        with log.open("a", encoding="utf-8") as file:
            subprocess.run([*mutmut, "run"], cwd=place, stdout=file, stderr=file, check=False)
        found = _told([*mutmut, "results", "--all", "true"], place)
        left = re.findall(r"(\S+): survived", found)
        told.append(f"{room}: {len(left)} of {found.count('__mutmut_')} survived")
        open_ += [each for each in left if _change([*mutmut, "show", each], place) not in answered]
    said = "; ".join(told)
    if open_:
        raise Failed(f"{said}; not answered in {ANSWERED.name}: {' '.join(open_)}")
    return said


def _settings(room: str, tests: Sequence[str]) -> str:
    lists = {
        "only_mutate": [f"lispac/{room}/*"],
        "do_not_mutate": COMPILED,
        "also_copy": ["tests/", "resources/", "installer/", "pyproject.toml", "README.md"],
        "pytest_add_cli_args_test_selection": [f"tests/test_{each}.py" for each in tests],
        # Each change has a process of its own, which would leave a virtual screen behind
        "pytest_add_cli_args": [
            "-n0",
            "-p",
            "no:cacheprovider",
            "-p",
            "no:xvfb",
            "-W",
            "ignore::pytest.PytestConfigWarning",
        ],
    }
    rows = [f"{name}=\n" + "".join(f"    {each}\n" for each in each_of)
            for name, each_of in lists.items()]  # fmt: skip
    return "[mutmut]\nsource_paths=lispac/\n" + "".join(rows)


def _told(command: Sequence[str], place: Path) -> str:
    done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False)
    return done.stdout


def _change(command: Sequence[str], place: Path) -> str:
    """The line a survivor puts in place of ours."""
    lines = [line[1:].strip() for line in _told(command, place).splitlines()
             if re.match(r"\+(?!\+\+)", line)]  # fmt: skip
    return "\n".join(lines)


def _clean_root(what: str) -> Step:
    def step(_folder: Path, log: Log) -> str:
        run([sys.executable, "-m", "tests.extras.clean_root", what], log)
        return log.read_text(encoding="utf-8").splitlines()[-1]

    return step


STEPS: dict[str, Step] = {
    "long": long,
    "coverage": coverage,
    "mutation": mutation,
    "bundle": _clean_root("bundle"),
    "readme": _clean_root("readme"),
}


def main() -> int:
    """Take the steps one after the other."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.extras.nightly", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("folder", type=Path, help="for the logs and what they tell of")
    parser.add_argument("steps", nargs="*", metavar="STEP", help=", ".join(STEPS))
    arguments = parser.parse_args()
    unknown = set(arguments.steps) - STEPS.keys()
    if unknown:
        parser.error(f"there is no step {', '.join(sorted(unknown))}; choose of {', '.join(STEPS)}")
    folder = arguments.folder.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for name in arguments.steps or STEPS:
        log, start = folder / f"{name}.log", time.monotonic()
        log.write_text("", encoding="utf-8")
        try:
            said, word = STEPS[name](folder, log), "done"
        except Failed as error:
            said, word, failed = str(error), "FAILED", failed + 1
        print(f"{name:10s}{word:8s}{(time.monotonic() - start) / 60:6.1f} min  {said}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
