"""Time of the command ``lispac validate`` on the harbour survey: five planes on six lines.

Elapsed and processor time, and peak memory, of separate processes; run with
``pytest -s tests/benchmarks/bench_validate.py``.
"""

import resource
import sys
from pathlib import Path
from statistics import median

from tests.benchmarks.bench_report import command_times

ROUNDS = 5


def test_validate(shared_data: Path, tmp_path: Path) -> None:
    data, project = shared_data / "harbour", str(tmp_path / "harbour")
    lispac = [sys.executable, "-m", "lispac"]
    files = [str(path) for path in sorted(data.glob("pass?.laz"))]
    trajectory = ["--trajectory", str(data / "trajectory.sbet")]
    accuracy = ["--trajectory-accuracy", str(data / "smrmsg.out")]
    lever_arm = ["--lever-arm", "-0.186", "0.038", "2.419"]
    command_times([*lispac, "new", project, *files, *trajectory, *accuracy, *lever_arm])
    command_times([*lispac, "propose", project, "--accept"])
    command_times([*lispac, "estimate", project])
    runs = [command_times([*lispac, "validate", project]) for _ in range(ROUNDS + 1)][1:]
    elapsed, processor = (median(each) for each in zip(*runs, strict=True))
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e6
    print(
        f"\nvalidate: {elapsed:.1f} s, of processor time {processor:.1f} s (least "
        f"{min(each for _, each in runs):.1f} s); memory of all commands at most {peak:.2f} GB"
    )
