"""A scanner from TOML."""

from pathlib import Path
from typing import cast

import numpy as np

from lispac.io.config.toml_table import TomlTable
from lispac.simulation.scanner import Axis, Scanner


def read_scanner(path: Path) -> tuple[str, Scanner]:
    """Read a scanner: its title and its specifications.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "scanner") as table:
        title = table.text("title")
        table.text("source", ""), table.boolean("unverified", False)  # for the sensor library
        axis = cast(Axis, table.one_of("axis", ("x", "z"), "x"))
        first, last = np.radians(table.numbers("window_deg", 2, low=-360, high=360))
        if not 0 < last - first <= 2 * np.pi + 1e-12:
            raise table.refuse("window_deg", "scanner.window")
        elevations = table.numbers("elevations_deg", None, (0.0,), low=-90, high=90)
        if not elevations:
            raise table.refuse("elevations_deg", "scanner.no_elevations")
        nearest = table.number("min_range_m", 0.0, low=0)
        return title, Scanner(
            pulses_per_second=table.number("pulses_per_second", over=0, high=1e7),
            turns_per_second=table.number("turns_per_second", over=0, high=1000),
            window=(float(first), float(last)),
            max_range=table.number("max_range_m", over=nearest),
            range_sigma=table.number("range_sigma_m", low=0),
            angle_sigma=float(np.radians(table.number("angle_sigma_deg", low=0))),
            divergence=table.number("divergence_mrad", low=0, high=100) / 1000,
            elevations=tuple(float(each) for each in np.radians(elevations)),
            axis=axis,
            min_range=nearest,
            incidence_growth=table.number("incidence_growth", 0.0, low=0, high=5),
            grazing=float(np.radians(table.number("grazing_deg", 90.0, over=0, high=90))),
        )
