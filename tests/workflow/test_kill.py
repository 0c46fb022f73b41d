"""Tests of SIGKILL during imports, saves and commands: files stay sound or are redone."""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import ProjectError
from lispac.io.project.project_file import read_project, write_project
from lispac.project import LineSource, PickedSighting, Project, Settings, Target
from lispac.survey.store import point_blocks, spool
from lispac.survey.store.line_import import write_store
from lispac.survey.store.stored_line import open_store
from lispac.workflow.project.projects import create_project
from tests.support.input_file_samples import LEVER, write_long_line, write_survey
from tests.support.store_lines import RECIPE, Line, place

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="no SIGKILL here")

CHECKOUT = Path(__file__).resolve().parents[2]
POINT_COUNT, BLOCK = 400_000, 20_000

IMPORT_SCRIPT = f"""
import sys
from pathlib import Path
from lispac.survey.store import point_blocks, spool
point_blocks.BLOCK_POINTS = spool.BLOCK_POINTS = {BLOCK}
from lispac.survey.store.spatial_cells import octave_runs_in_sphere
from lispac.survey.store.line_import import write_store
from tests.support.store_lines import RECIPE, Line, place
line = Line({POINT_COUNT})
print("ready", flush=True)
write_store(Path(sys.argv[1]), RECIPE, line.pieces(30_000), place)
print("done", flush=True)
"""

SAVE_SCRIPT = """
import sys
from dataclasses import replace
from pathlib import Path
import numpy as np
from lispac.io.project.project_file import read_project, write_project
folder = Path(sys.argv[1])
project = replace(read_project(folder.with_name("pristine")), folder=folder)
one, *rest = project.targets
states = []
for k in (1, 2):
    moved = [
        replace(sighting, indices=sighting.indices[::k], rms=k / 1000) for sighting in one.sightings
    ]
    states.append(
        replace(project, targets=(replace(one, sightings=tuple(moved)), *rest))
    )
print("ready", flush=True)
while True:
    for state in states:
        write_project(state)
"""


def run_and_kill(code: str, argument: Path, seconds: float | None) -> float:
    """Run code in a process of its own and kill it a given time after it is ready.

    Parameters
    ----------
    seconds : float or None
        Time before the kill; None lets the process end by itself.

    Returns
    -------
    float
        Seconds from being ready to the end of the process.
    """
    with subprocess.Popen(
        [sys.executable, "-c", code, str(argument)], stdout=subprocess.PIPE, text=True,
        cwd=CHECKOUT, env=os.environ | {"PYTHONPATH": str(CHECKOUT)},
    ) as process:  # fmt: skip
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        start = time.monotonic()
        if seconds is None:
            assert process.stdout.read() == "done\n"
        else:
            time.sleep(seconds)
            process.send_signal(signal.SIGKILL)
            process.stdout.read()
        assert process.wait() == 0 or seconds is not None
        return time.monotonic() - start


@pytest.mark.parametrize("times", [2, pytest.param(20, marks=pytest.mark.long)])
def test_kill_during_import(tmp_path: Path, monkeypatch, times: int) -> None:
    for module in (point_blocks, spool):
        monkeypatch.setattr(module, "BLOCK_POINTS", BLOCK)
    line = Line(POINT_COUNT)
    took = run_and_kill(IMPORT_SCRIPT, tmp_path / "whole", None)
    whole = open_store(tmp_path / "whole", "L1").manifest
    moments = random.Random(7)
    counts = {"complete": 0, "interrupted while reading": 0, "while ordering": 0, "not imported": 0}
    for k in range(times):
        folder = tmp_path / f"L{k}"
        # The moments are spread over the whole import and shortly after it.
        run_and_kill(IMPORT_SCRIPT, folder, 1.1 * took * (k + moments.random()) / times)
        ordering = bool(list(folder.glob("columns-*")))
        try:
            stored = open_store(folder, "L1")
        except ProjectError as error:
            code = error.code
            if code == "store.not_imported":
                counts["not imported"] += 1
            else:
                assert code == "store.interrupted"
                counts["while ordering" if ordering else "interrupted while reading"] += 1
        else:
            counts["complete"] += 1
            stored.require_sound()
        manifest = write_store(folder, RECIPE, line.pieces(30_000), place)
        assert [c.checksum for c in manifest.files] == [c.checksum for c in whole.files]
        assert {path.name for path in folder.iterdir()} == {"store.json", manifest.folder}
        for path in folder.rglob("*.npy"):
            path.unlink()
    print(f"\n{times} imports of {took:.2f} s killed: {counts}")
    assert counts["interrupted while reading"] + counts["while ordering"] > 0


@pytest.mark.parametrize(
    ("points", "times"),
    [
        pytest.param(50_000, 2, marks=pytest.mark.long),
        pytest.param(10_000_000, 50, marks=[pytest.mark.long, pytest.mark.timeout(7200)]),
    ],
)
def test_kill_during_the_import_command(tmp_path: Path, points: int, times: int) -> None:
    """The project opens, and the next import completes and removes temporary files."""
    (tmp_path / "files").mkdir()
    files = write_survey(tmp_path / "files")
    project = create_project(
        tmp_path / "p", trajectory=files / "pos.sbet", accuracy=files / "smrmsg.out",
        lines=[LineSource("L1", write_long_line(files / "long.las", points))],
        settings=Settings(LEVER),
    )  # fmt: skip
    words = ["import", str(project.folder)]
    took = command_killed(words, None)
    whole = open_store(project.folder / "lines" / "L1", "L1").manifest
    moments, found = random.Random(11), {"complete": 0, "incomplete": 0}
    for k in range(times):
        shutil.rmtree(project.folder / "lines")
        command_killed(words, took * (k + moments.random()) / times)
        assert [line.name for line in read_project(project.folder).lines] == ["L1"]
        try:
            open_store(project.folder / "lines" / "L1", "L1").require_sound()
        except ProjectError as error:
            state = error.code
        else:
            state = "complete"
        assert state in ("store.not_imported", "store.interrupted", "complete")
        found["complete" if state == "complete" else "incomplete"] += 1
        assert main(words) == 0
        stored = open_store(project.folder / "lines" / "L1", "L1")
        stored.require_sound()
        assert [c.checksum for c in stored.manifest.files] == [c.checksum for c in whole.files]
        remaining = {path.name for path in (project.folder / "lines" / "L1").iterdir()}
        assert remaining == {"store.json", stored.manifest.folder}
        assert not list(project.folder.rglob(".*"))
    print(f"\n{times} imports of {points:,} points, {took:.1f} s each, killed: {found}")
    assert found["incomplete"] > 0


def test_kill_during_a_repeated_import(tmp_path: Path, monkeypatch) -> None:
    """The old store is kept until the new one is complete."""
    for module in (point_blocks, spool):
        monkeypatch.setattr(module, "BLOCK_POINTS", BLOCK)
    folder = tmp_path / "L1"
    write_store(folder, RECIPE, Line(30_000, seed=8).pieces(30_000), place)
    run_and_kill(IMPORT_SCRIPT, folder, 0.3)
    stored = open_store(folder, "L1")
    assert len(stored) in (30_000, POINT_COUNT)
    stored.require_sound()


def project_in(folder: Path) -> Project:
    """Save a project of three lines and two targets, and return it."""
    rng = np.random.default_rng(1)
    lines = tuple(LineSource(f"L{k}", folder / f"L{k}.las") for k in range(3))
    targets = tuple(
        Target(
            name, "target", (1.0, 2.0, 3.0), 0.01, 0.5,
            tuple(
                PickedSighting(line.name, np.sort(rng.integers(0, 10**7, 30_000)), 0.003)
                for line in lines
            ),
        )
        for name in ("T1", "T2")
    )  # fmt: skip
    project = Project(
        folder=folder,
        trajectory=folder / "t.sbet",
        lines=lines,
        settings=Settings((0.0, 0.0, 1.0)),
        targets=targets,
    )
    write_project(project)
    return project


@pytest.mark.parametrize("times", [2, pytest.param(20, marks=pytest.mark.long)])
def test_kill_during_save(tmp_path: Path, times: int) -> None:
    shutil.copytree(project_in(tmp_path / "project").folder, tmp_path / "pristine")
    indices = project_in(tmp_path / "project").targets[0].sightings[0].indices
    moments = random.Random(3)
    outcomes = []
    for _ in range(times):
        run_and_kill(SAVE_SCRIPT, tmp_path / "project", moments.uniform(0.0, 0.4))
        found = read_project(tmp_path / "project").target("T1").sightings[0]
        half = found.rms == 0.002
        np.testing.assert_array_equal(found.indices, indices[:: 2 if half else 1])
        outcomes.append(half)
    print(f"\n{times} times killed while saving; {sum(outcomes)} times the one state was left")
    if times > 10:
        assert len(set(outcomes)) == 2


COMMAND_SCRIPT = """
import sys
from lispac.cli.main import main
print("ready", flush=True)
main(sys.argv[1:])
"""


def command_killed(words: list[str], seconds: float | None) -> float:
    """Run a command in a process of its own and kill it after a time; see `run_and_kill`."""
    with subprocess.Popen(
        [sys.executable, "-c", COMMAND_SCRIPT, *words],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=CHECKOUT,
        env=os.environ | {"PYTHONPATH": str(CHECKOUT)},
    ) as process:  # fmt: skip
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        start = time.monotonic()
        if seconds is not None:
            time.sleep(seconds)
            process.send_signal(signal.SIGKILL)
        process.stdout.read()
        assert process.wait() == 0 or seconds is not None
        return time.monotonic() - start


@pytest.mark.parametrize(
    ("name", "times"),
    [
        ("export", 1),
        *(
            pytest.param(name, 50, marks=[pytest.mark.long, pytest.mark.timeout(3600)])
            for name in ("pick", "estimate", "report", "georeference", "export")
        ),
    ],
)
def test_kill_during_a_command(copy: Project, tmp_path: Path, name: str, times: int) -> None:
    """The project opens, and the next run completes and removes temporary files."""
    folder, out = str(copy.folder), tmp_path / "out"
    first = copy.targets[0]
    words = {
        "pick": ["--name", "T9", "--seed", *(f"{value:.3f}" for value in first.seed)],
        "estimate": ["--no-cross-checks"],
        "report": ["--output", str(out / "r.pdf")],
        "georeference": ["--output", str(out), "--crs", "local", "--lines", copy.lines[0].name],
        "export": ["--what", "targets", "--output", str(out / "targets.laz"), "--crs", "local"],
    }[name]
    words = [name, folder, *words]
    took = command_killed(words, None)
    complete = {path.name for path in out.glob("*")}
    chance = random.Random(name)
    for _ in range(times):
        command_killed(words, took * chance.random())
        read_project(copy.folder)
        assert main(words) == 0
        remaining = [path for place in (copy.folder, out) for path in place.rglob(".*")]
        assert remaining == []
        assert {path.name for path in out.glob("*")} == complete
