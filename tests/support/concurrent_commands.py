"""Commands for tests with two concurrent processes on one project."""

import json
import shutil
from concurrent.futures import ProcessPoolExecutor
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from io import StringIO
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from lispac.cli.main import main
from lispac.workflow.planning.demo import demo_seeds

Words = tuple[str, ...]


def commands() -> dict[str, Words]:
    """Commands that change a project, by name; the folder follows the first word."""
    seeds = demo_seeds()
    picks = {
        f"pick {name}": (
            "pick", "--name", f"{name} again", "--role", role,
            "--seed", *(f"{value:.3f}" for value in seed),
        )
        for name, (role, seed) in list(seeds.items())[:2]
    }  # fmt: skip
    return {
        "vessel": ("identity", "--vessel", "Vessel"),
        "site": ("identity", "--site", "Site"),
        **picks,
        "estimate": ("estimate", "--no-cross-checks"),
        "other estimate": ("estimate", "--no-cross-checks", "--subsample", "0.3"),
        "validate": ("validate",),
    }


def run(words: Words, folder: Path) -> tuple[int, str]:
    """Exit status and stderr of a command."""
    out, err = StringIO(), StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        status = main([words[0], str(folder), *words[1:]])
    return status, err.getvalue()


def state(folder: Path) -> dict[str, Any]:
    """Content of the project file without computation times."""
    content = json.loads((folder / "project.json").read_text())
    return _without_times(content)


def _without_times(content: Any) -> Any:
    if isinstance(content, dict):
        return {k: _without_times(v) for k, v in content.items() if k != "elapsed"}
    return [_without_times(each) for each in content] if isinstance(content, list) else content


@dataclass
class SerialRuns:
    """Results of commands that run one after the other; each order is computed once."""

    project: Path
    folder: Path

    def __post_init__(self) -> None:
        self._known: dict[tuple[Words, ...], tuple[list[int], dict[str, Any]]] = {}

    def after(self, *order: Words) -> tuple[list[int], dict[str, Any]]:
        """Exit statuses and the state of the project after the commands in this order."""
        if order not in self._known:
            place = self.folder / f"serial-{len(self._known)}"
            copy_of(self.project, place)
            status = [run(words, place)[0] for words in order]
            self._known[order] = status, state(place)
            shutil.rmtree(place)
        return self._known[order]


def copy_of(project: Path, place: Path) -> Path:
    """A fresh copy of a project, whose files are in its folder."""
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(project, place)
    return place


def pool() -> ProcessPoolExecutor:
    """Pool of two persistent processes."""
    return ProcessPoolExecutor(2, mp_context=get_context("spawn"))


def random_pairs(pairs: int, seed: int = 35) -> list[tuple[str, str]]:
    """Random pairs of commands, including pairs of the same command."""
    names, chance = list(commands()), np.random.default_rng(seed)
    return [(names[i], names[j]) for i, j in chance.integers(len(names), size=(pairs, 2))]
