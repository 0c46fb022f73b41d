"""``lispac replay``: a survey against the plan it was sailed by."""

from argparse import Namespace

import numpy as np

from lispac.adjustment.result import ANGLES
from lispac.cli.console import ConsoleProgress, print_json
from lispac.io.plan_file import read_plan
from lispac.workflow.projects import open_project
from lispac.workflow.replay import replay as replayed
from lispac.workflow.survey import load_survey


def replay(arguments: Namespace) -> None:
    """Print what was foretold, what of it was sailed, and what came of it."""
    titled = read_plan(arguments.plan)
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    found = replayed(project, survey, titled)
    rows = {
        "planned": found.planned,
        "sailed": found.sailed,
        "as_flat": found.as_flat,
        "obtained": found.obtained,
    }
    if arguments.json:
        values: dict[str, object] = {
            f"{name}_sigma_deg": np.degrees(row).tolist() if np.isfinite(row).all() else None
            for name, row in rows.items()
        }
        values["flatness_m"] = list(found.flatness)
        values["missing_targets"] = list(found.missing_targets)
        values["missing_lines"] = [line.name for line in found.missing_lines]
        print_json(values | {"words": [*found.off_plan, *found.costs]})
        return
    print(f"{'1 sigma, deg':32s}" + "".join(f"{angle:>9s}" for angle in ANGLES))
    words = {
        "planned": "the plan, foretold",
        "sailed": "what was sailed of it",
        "as_flat": "with targets as flat as found",
        "obtained": "stated by the adjustment",
    }
    for name, row in rows.items():
        cells = "".join(f"{value:9.4f}" for value in np.degrees(row))
        print(f"{words[name]:32s}{cells if np.isfinite(row).all() else '   not determined'}")
    ratio = found.obtained / found.as_flat
    print(f"{'stated over foretold':32s}" + "".join(f"{value:9.2f}" for value in ratio))
    planned, came = (1000 * value for value in found.flatness)
    print(f"Targets were planned to be flat to {planned:.2f} mm; the survey found {came:.2f} mm.")
    for sentence in (*found.off_plan, *found.costs):
        print(sentence)
