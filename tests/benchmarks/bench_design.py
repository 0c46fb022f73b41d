"""Time of one design and of ten thousand, and the speed-up by a second process.

Run with ``pytest tests/benchmarks`` on an idle machine.
"""

from pathlib import Path
from time import perf_counter

import numpy as np

from lispac.design.monte_carlo import run_monte_carlo
from lispac.design.objective import PlanObjective
from lispac.design.plan_choices import DesignSpace, thesis_plan
from lispac.design.plan_search import search
from lispac.design.prediction import predict
from lispac.io.config.plan_file import read_site
from lispac.workflow.planning.process_pool import process_pool_mapper

QUAY = Path(__file__).parents[2] / "resources" / "sites" / "quay.toml"
DESIGNS = 10_000


def test_one_design():
    _, site = read_site(QUAY)
    space = DesignSpace(site, PlanObjective())
    generator = np.random.default_rng(1)
    widths = np.array(space.gene_sizes)
    choices = [space.choice(generator.integers(widths)) for _ in range(300)]
    predict(thesis_plan(site))  # compile
    times = []
    for choice in choices:
        start = perf_counter()
        space.value(choice)
        times.append(1000 * (perf_counter() - start))
    print(f"\none design of the quay: median {np.median(times):.2f} ms, most {max(times):.2f} ms")


def test_ten_thousand_designs():
    _, site = read_site(QUAY)
    found = {}
    for workers in (1, 2):
        start = perf_counter()
        with process_pool_mapper(workers) as mapper:
            design = search(site, plans=DESIGNS, mapper=mapper)
        found[workers] = perf_counter() - start
        print(
            f"\n{design.evaluated:,} designs of the quay, {workers} processes: "
            f"{found[workers]:.1f} s, value {np.degrees(design.value):.4f} deg"
        )
    print(f"speed-up with two: {found[1] / found[2]:.2f}")


def test_monte_carlo():
    _, site = read_site(QUAY)
    plan = thesis_plan(site)
    run_monte_carlo(plan, 2)  # compile
    found = {}
    for workers in (1, 2):
        start = perf_counter()
        with process_pool_mapper(workers) as mapper:
            run_monte_carlo(plan, 100, mapper=mapper)
        found[workers] = perf_counter() - start
        print(f"\n100 surveys, {workers} processes: {found[workers]:.1f} s")
    print(f"speed-up with two: {found[1] / found[2]:.2f}")
