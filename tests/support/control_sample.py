"""Control with invented residuals, for tests of reports, warnings and views."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from lispac.adjustment.result import (
    ControlResidual,
    ControlTranslation,
    EstimateWithoutControl,
)
from lispac.control_points import ControlFile, ControlPoint
from lispac.messages import note
from lispac.project import Project

SOURCE = "control.csv"


def with_control(
    project: Project, *, w: float = 1.2, translation: tuple[float, float, float] | None = None
) -> Project:
    """Project whose result contains two control points on T1, the second with test value ``w``.

    A third point is not assigned. With ``translation``, metres, the file is displaced as a whole.
    """
    assert project.result is not None
    residuals = tuple(
        ControlResidual(
            f"C{k}",
            "T1",
            SOURCE,
            False,
            0.0011 * k,
            0.003,
            0.62,
            0.0031 * value,
            0.0031,
            value,
            contradicts=translation is None and abs(value) > 4.0,
        )
        for k, value in ((1, -0.4), (2, w))
    )
    moved: tuple[ControlTranslation, ...] = ()
    if translation is not None:
        found = ControlTranslation(SOURCE, np.array(translation), np.full(3, 0.004), 1e-30, True)
        moved = (found,)
    points = [
        ControlPoint(f"C{k}", "T1", (0.6, -14.7, 5.0 + k), (0.003, 0.003, 0.003)) for k in (1, 2)
    ]
    reason = note("control.beside_targets", name="C3")
    points.append(ControlPoint("C3", "", (50.0, 3.0, 1.0), (0.003, 0.003, 0.003), reason=reason))
    file = ControlFile(
        Path(project.folder / SOURCE), 1234, "0" * 64, "points", "the local frame",
        (45.5, -73.5, -25.6), 0.002, tuple(points),
    )  # fmt: skip
    alone = EstimateWithoutControl(
        project.result.angles + np.radians(0.002),
        1.3 * project.result.sigma,
        tuple(replace(each, value=None, sigma=None) for each in project.result.parameters),
    )
    result = replace(
        project.result, control=residuals, control_translations=moved, without_control=alone
    )
    return replace(project, control=(file,), result=result)
