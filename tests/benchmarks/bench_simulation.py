"""Time to simulate the built-in survey; run with ``pytest tests/benchmarks``."""

from time import perf_counter

from lispac.simulation.simulated_survey import port_survey


def test_port_survey():
    port_survey(points_per_second=5_000.0)  # compile
    start = perf_counter()
    survey = port_survey()
    elapsed = perf_counter() - start
    points = sum(len(line.time) for line in survey.lines)
    print(f"\nport survey: {points / 1e6:.2f} M points of six lines in {elapsed:.2f} s")
