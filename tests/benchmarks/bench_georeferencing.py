"""Points georeferenced per second: the fused kernel beside the vectorised NumPy formula."""

from statistics import median
from time import perf_counter

import numpy as np

from lispac.survey.georeferencing import georeference, place
from tests.test_georeferencing import survey


def test_kernel_beside_numpy():
    count, rounds = 4_000_000, 5
    path, points, time, mounting = survey(count)
    time.sort()
    georeference(points[:1000], time[:1000], path, mounting)  # compile
    kernel, numpy = [], []
    for _ in range(rounds):
        start = perf_counter()
        fused = georeference(points, time, path, mounting)
        kernel.append(perf_counter() - start)
        start = perf_counter()
        vectorised = place(points, path.at(time), mounting)
        numpy.append(perf_counter() - start)
    assert np.abs(fused - vectorised).max() < 1e-9
    ratio = median(n / k for n, k in zip(numpy, kernel, strict=True))
    print(
        f"\ngeoreferencing: kernel {count / median(kernel) / 1e6:.1f} M points/s, "
        f"NumPy {count / median(numpy) / 1e6:.1f} M points/s, ratio {ratio:.1f}"
    )
