"""Start time of commands, each in a separate process.

Target: 0.3 s for ``lispac --version``, so heavy modules must not be imported at the start.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

CHECKOUT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    "words",
    [
        ["-m", "lispac", "--version"],
        ["-m", "lispac", "--help"],
        ["-c", "import lispac"],
        ["-c", "import lispac; lispac.open"],
        ["-c", "pass"],
    ],
    ids=["lispac --version", "lispac --help", "import lispac", "lispac.open", "Python alone"],
)
def test_start_times(benchmark: BenchmarkFixture, words: list[str]) -> None:
    variables = {**os.environ, "PYTHONPATH": str(CHECKOUT)}

    def start() -> None:
        subprocess.run(
            [sys.executable, *words], check=True, capture_output=True, env=variables, cwd=CHECKOUT
        )

    benchmark.pedantic(start, rounds=7, warmup_rounds=1)
