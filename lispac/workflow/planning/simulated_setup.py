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

PART_KINDS = ("scene", "vessel", "scanner")
"""Kinds of files that a simulation is composed of."""
MAX_ORIGIN_DISTANCE = 20_000.0
"""Largest distance of the origin of a scene from the trajectory, metres."""
MAX_SURVEY_DURATION = 12 * 3600.0
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
    scene_data = read_scene(files["scene"])
    scene_folder = files["scene"].parent
    files["vessel"] = setup_file(
        "vessel", vessel or scene_data.vessel, None if vessel else scene_folder
    )
    files["scanner"] = setup_file(
        "scanner", scanner or scene_data.scanner, None if scanner else scene_folder
    )
    vessel_data = read_vessel(files["vessel"])
    scanner_title, instrument = read_scanner(files["scanner"])
    rate = points_per_second or scene_data.pulses_per_second
    if rate is not None:
        instrument = replace(instrument, pulses_per_second=rate)
    origin, motion = _origin_and_motion(scene_data, vessel_data, trajectory, files["scene"])
    setup = SurveySetup(
        origin, scene_data.scene, scene_data.targets, scene_data.validation, motion,
        vessel_data.pos, instrument,
        replace(vessel_data.errors, **(errors or {})).mounting(vessel_data.lever_arm),
    )  # fmt: skip
    titles = {"scene": scene_data.title, "vessel": vessel_data.title, "scanner": scanner_title}
    return SimulatedSetup(setup, vessel_data.lever_arm, titles, files)


_NOT_FOUND_CODES = {
    "scene": "simulate.no_scene",
    "vessel": "simulate.no_vessel",
    "scanner": "simulate.no_scanner",
}
"""Code of the error that no file of a kind has a given name."""


def setup_file(kind: str, word: str, scene_folder: Path | None) -> Path:
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
        raise InputError(error(_NOT_FOUND_CODES[kind], name=word, known=tuple(known)))
    return path if scene_folder is None else scene_folder / path


def _origin_and_motion(
    scene_data: SceneFile, vessel_data: Vessel, trajectory: Path | None, file: Path
) -> tuple[tuple[float, float, float], MotionSource]:
    recorded = trajectory or scene_data.trajectory
    if recorded is None:
        if not scene_data.lines:
            raise InputError(error("simulate.no_trajectory", file=str(file)))
        if scene_data.origin is None:
            raise InputError(error("simulate.no_origin", file=str(file)))
        lines = tuple(replace(each, handling=vessel_data.handling) for each in scene_data.lines)
        takes = sum(each.times[1] - each.times[0] for each in lines)
        takes += len(lines) * vessel_data.handling.transit + 2 * vessel_data.handling.wait
        if takes > MAX_SURVEY_DURATION:
            raise InputError(
                error(
                    "simulate.too_long",
                    file=str(file),
                    vessel=vessel_data.title,
                    duration=takes,
                    limit=MAX_SURVEY_DURATION,
                )
            )
        return scene_data.origin, SailedTrajectory(lines, vessel_data.pos_height)
    if not scene_data.stretches:
        raise InputError(
            error("simulate.lines_by_heading", file=str(file), trajectory=str(recorded))
        )
    states = read_sbet(recorded)
    mean = states.mean_frame()
    origin = scene_data.origin or (mean.latitude, mean.longitude, mean.height)
    frame = replace(mean, latitude=origin[0], longitude=origin[1], height=origin[2])
    local = LocalTrajectory.of(states, frame)
    distance = float(np.linalg.norm(local.position, axis=1).min())
    if distance > MAX_ORIGIN_DISTANCE:
        raise InputError(
            error(
                "simulate.origin_too_far",
                file=str(file),
                distance=distance,
                trajectory=str(recorded),
            )
        )
    return origin, RecordedTrajectory(local, scene_data.stretches)
