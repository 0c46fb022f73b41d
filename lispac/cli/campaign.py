"""``lispac campaign``: many simulated surveys of a plan, and whether its sigmas hold."""

from argparse import Namespace

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.console import ConsoleProgress, print_json
from lispac.design.choices import faces_one_way
from lispac.design.monte_carlo import Scatter, surveyed
from lispac.errors import RankDeficient
from lispac.io.plan_file import read_plan
from lispac.workflow.campaign import mapper_of
from lispac.workflow.designing import ONE_WAY


def campaign(arguments: Namespace) -> None:
    """Print how the answers scatter beside the stated and the foretold sigmas."""
    titled = read_plan(arguments.plan)
    if faces_one_way(titled.plan):
        raise RankDeficient(ONE_WAY)
    with (
        ConsoleProgress() as progress,
        mapper_of(arguments.workers, arguments.cluster) as mapper,
    ):
        found = surveyed(
            titled.plan, arguments.surveys, seed=arguments.seed,
            flatness_known=arguments.flatness_known, mapper=mapper, progress=progress,
        )  # fmt: skip
    if arguments.json:
        print_json(
            {
                "title": titled.title,
                "surveys": arguments.surveys,
                "seed": arguments.seed,
                "failed": found.failed,
                "scatter_deg": np.degrees(found.empirical).tolist(),
                "stated_sigma_deg": np.degrees(found.stated).tolist(),
                "foretold_sigma_deg": np.degrees(found.foretold).tolist(),
                "hits_95": found.hits.tolist(),
                "words": list(found.words),
            }
        )
        return
    print(f"{titled.title}: {arguments.surveys:,} surveys simulated and adjusted")
    print(table(found))
    for sentence in found.words:
        print(sentence)


def table(found: Scatter) -> str:
    """Sigmas and hits, a row each, the angles side by side."""
    ratio = found.empirical / found.foretold
    rows = [
        ("scatter, deg", *(f"{v:.4f}" for v in np.degrees(found.empirical))),
        ("stated sigma, deg", *(f"{v:.4f}" for v in np.degrees(found.stated))),
        ("foretold sigma, deg", *(f"{v:.4f}" for v in np.degrees(found.foretold))),
        ("scatter / foretold", *(f"{v:.2f}" for v in ratio)),
        ("95 % intervals right", *(f"{share:.1%}" for share in found.hits)),
    ]
    lines = [f"{name:22s}" + "".join(f"{cell:>9s}" for cell in row) for name, *row in rows]
    lines[3] += f"   (+- {found.by_chance:.2f} by chance)"
    return "\n".join([" " * 22 + "".join(f"{angle:>9s}" for angle in ANGLES), *lines])
