"""Setup of a simulation from the names of a scene, a vessel and a scanner."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from lispac.errors import InputError
from lispac.installation_paths import resource_path
from lispac.io.config.scanner_file import read_scanner
from lispac.io.config.scene_file import SceneFile, read_scene
from lispac.io.config.toml_table import TomlTable
from lispac.io.config.vessel_file import Vessel, read_vessel
from lispac.io.trajectory.sbet import read_sbet
from lispac.messages import error
from lispac.project import Triple
from lispac.simulation.motion_source import MotionSource, RecordedTrajectory, SailedTrajectory
from lispac.simulation.simulated_survey import SurveySetup
from lispac.survey.trajectory import LocalTrajectory

KINDS = ("scene", "vessel", "scanner")
MAX_DISTANCE = 20_000.0
"""Largest distance of the origin of a scene from the trajectory, metres."""
MAX_DURATION = 12 * 3600.0
"""Longest simulated survey, seconds; a longer one is an input error and would not fit in memory."""


@dataclass(frozen=True, eq=False)
class SimulatedSetup:
    """Setup of a simulated survey, with the values that the surveyor would know.

    Attributes
    ----------
    setup : SurveySetup
    lever_arm : three of float, metres, body
        Lever arm given by the surveyor; the true one is in the setup.
    titles : dict of str to str
        Titles of scene, vessel and scanner.
    files : dict of str to Path
        Files of scene, vessel and scanner.
    """

    setup: SurveySetup
    lever_arm: Triple
    titles: Mapping[str, str]
    files: Mapping[str, Path]


def supplied_titles(kind: str) -> dict[str, str]:
    """Names and titles of the scenes, vessels, scanners or sites that come with the program."""
    found = {}
    for path in sorted(resource_path(f"{kind}s").glob("*.toml")):
        with TomlTable.read(path, kind) as table:
            found[path.stem] = table.text("title")
            table.ignore_rest()
    return found


def read_simulation(
    scene: str,
    *,
    vessel: str | None = None,
    scanner: str | None = None,
    trajectory: Path | None = None,
    points_per_second: float | None = None,
    errors: Mapping[str, Any] | None = None,
) -> SimulatedSetup:
    """Combine scene, vessel and scanner.

    Parameters
    ----------
    scene, vessel, scanner : str
        Name supplied with the program, or a file; vessel and scanner are by default those specified
        in the scene.
    trajectory : Path, optional
        SBET used as the truth, instead of that of the scene.
    points_per_second : float, optional
        Pulses per second of the scanner, instead of its own or the scene's.
    errors : mapping, optional
        Fields of `MountingErrors` that replace those of the vessel.

    Raises
    ------
    InputError
        If a file is not valid or the parts do not fit.
    """
    files = {"scene": setup_file("scene", scene, None)}
    described = read_scene(files["scene"])
    beside = files["scene"].parent
    files["vessel"] = setup_file("vessel", vessel or described.vessel, None if vessel else beside)
    files["scanner"] = setup_file(
        "scanner", scanner or described.scanner, None if scanner else beside
    )
    carried = read_vessel(files["vessel"])
    scanner_title, instrument = read_scanner(files["scanner"])
    rate = points_per_second or described.pulses_per_second
    if rate is not None:
        instrument = replace(instrument, pulses_per_second=rate)
    origin, voyage = _origin_and_voyage(described, carried, trajectory, files["scene"])
    setup = SurveySetup(
        origin, described.scene, described.targets, described.validation, voyage, carried.pos,
        instrument, replace(carried.errors, **(errors or {})).mounting(carried.lever_arm),
    )  # fmt: skip
    titles = {"scene": described.title, "vessel": carried.title, "scanner": scanner_title}
    return SimulatedSetup(setup, carried.lever_arm, titles, files)


_UNKNOWN = {
    "scene": "simulate.no_scene",
    "vessel": "simulate.no_vessel",
    "scanner": "simulate.no_scanner",
}
"""Code of the message that there is no file of a kind with a name."""


def setup_file(kind: str, word: str, beside: Path | None) -> Path:
    """File with a name or path; paths in a scene are relative to its folder.

    Raises
    ------
    InputError
        If there is none of that name.
    """
    path = Path(word)
    if path.suffix.lower() != ".toml":
        known = supplied_titles(kind)
        if word in known:
            return resource_path(f"{kind}s") / f"{word}.toml"
        raise InputError(error(_UNKNOWN[kind], name=word, known=tuple(known)))
    return path if beside is None else beside / path


def _origin_and_voyage(
    described: SceneFile, carried: Vessel, trajectory: Path | None, file: Path
) -> tuple[tuple[float, float, float], MotionSource]:
    recorded = trajectory or described.trajectory
    if recorded is None:
        if not described.lines:
            raise InputError(error("simulate.no_trajectory", file=str(file)))
        if described.origin is None:
            raise InputError(error("simulate.no_origin", file=str(file)))
        lines = tuple(replace(each, handling=carried.handling) for each in described.lines)
        takes = sum(each.times[1] - each.times[0] for each in lines)
        takes += len(lines) * carried.handling.transit + 2 * carried.handling.wait
        if takes > MAX_DURATION:
            raise InputError(
                error(
                    "simulate.too_long",
                    file=str(file),
                    vessel=carried.title,
                    duration=takes,
                    limit=MAX_DURATION,
                )
            )
        return described.origin, SailedTrajectory(lines, carried.pos_height)
    if not described.stretches:
        raise InputError(
            error("simulate.lines_by_heading", file=str(file), trajectory=str(recorded))
        )
    states = read_sbet(recorded)
    mean = states.mean_frame()
    origin = described.origin or (mean.latitude, mean.longitude, mean.height)
    frame = replace(mean, latitude=origin[0], longitude=origin[1], height=origin[2])
    local = LocalTrajectory.of(states, frame)
    farthest = float(np.linalg.norm(local.position, axis=1).min())
    if farthest > MAX_DISTANCE:
        raise InputError(
            error(
                "simulate.origin_too_far",
                file=str(file),
                distance=farthest,
                trajectory=str(recorded),
            )
        )
    return origin, RecordedTrajectory(local, described.stretches)
