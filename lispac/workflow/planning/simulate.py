"""Simulated surveys as projects: files as of a real survey, and files with the true values."""

import json
import re
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path, PurePosixPath
from tempfile import mkdtemp

import numpy as np

from lispac.errors import InputError, ProjectError
from lispac.io.files import atomic_write, bad_name_error, remove_empty_folders, write_error
from lispac.io.las.las_format import write_points
from lispac.io.project.project_file import PROJECT_FILE_NAME, SIGHTINGS_FOLDER, remove_point_files
from lispac.io.text.text_export import write_table
from lispac.io.trajectory.sbet import write_sbet, write_smrmsg
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import LineSource, Project, Settings, Triple
from lispac.simulation.pos_error_models import CombinedModel
from lispac.simulation.pos_errors import PosErrorModel
from lispac.simulation.scene import Sphere
from lispac.simulation.simulated_survey import SimulatedSurvey, simulate_survey
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES
from lispac.survey.store.layout import require_no_link
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy
from lispac.untrusted_values import json_values
from lispac.value_conversion import encode_value
from lispac.workflow.planning.simulated_setup import SimulatedSetup
from lispac.workflow.project.projects import create_project

RAW_FOLDER, TRUTH_FOLDER, SIMULATION_MARKER_FILE = "raw", "truth", "simulated"
"""Folders of the survey files and of the true values, and the file in the first of them that marks
a simulation, which may be replaced."""
TRUTH_FILES = (f"{TRUTH_FOLDER}/truth.json", f"{TRUTH_FOLDER}/labels.npz")
"""Files with the true values: mounting and simulation, and the surface of each point."""
TRAJECTORY_FILE, ACCURACY_FILE = "trajectory.sbet", "smrmsg.out"
TARGET_LIST_FILE = "targets.csv"
"""List of coordinates that ``lispac pick --seeds`` reads."""
SPHERE_LIST_FILE = "balls.csv"
"""List of coordinates of spheres, for ``--shape sphere``."""
_UNFINISHED_FOLDER_PATTERN = re.compile(r"\.survey-\w{8}\.part")
"""Name of the folder in which a survey is written before it replaces an earlier one."""


def simulate(
    folder: Path,
    simulation: SimulatedSetup,
    *,
    seed: int,
    noise: bool = True,
    pos_errors: bool = True,
    progress: Progress = no_progress,
) -> tuple[Project, dict[str, int]]:
    """Simulate a survey and write it as a new project with raw files but no targets.

    An earlier simulation in the folder is replaced when the new one is complete.

    Returns
    -------
    project : Project
    points : dict of str to int
        Number of points of each line.

    Raises
    ------
    ProjectError
        If the folder contains anything other than a simulation.
    InputError
        If a line has no points, or a file cannot be written.
    """
    folder = Path(folder).absolute()
    require_replaceable(folder, SIMULATION_MARKER_FILE)
    settings = _surveyor_settings(simulation)
    settings.require_sound()
    survey = simulate_survey(
        simulation.setup, seed=seed, noise=noise, pos_errors=pos_errors,
        progress=sub_progress(progress, 0.0, 0.6),
    )  # fmt: skip
    for line in survey.lines:
        if not len(line.time):
            raise InputError(error("simulate.line_without_points", line=line.name))
    mark = "Simulated survey; each simulation replaces it.\n"
    with replaced_survey(
        folder, SIMULATION_MARKER_FILE, mark, (*TRUTH_FILES, TARGET_LIST_FILE, SPHERE_LIST_FILE)
    ) as new:
        write_lines(survey, new / RAW_FOLDER, progress=sub_progress(progress, 0.6, 0.95))
        write_trajectory(survey, new / RAW_FOLDER)
        _write_truth(survey, simulation, new, seed)
    project = create_simulated_project(
        folder, [line.name for line in survey.lines], settings, np.degrees(survey.boresight)
    )
    progress(1.0)
    return project, {line.name: len(line.time) for line in survey.lines}


def create_simulated_project(
    folder: Path, lines: Sequence[str], settings: Settings, truth_deg: np.ndarray
) -> Project:
    """Create the project of a simulated survey in ``folder``.

    Parameters
    ----------
    lines : sequence of str
        Names of the lines, whose files are in the folder ``raw``.
    truth_deg : ndarray of shape (3,)
        True boresight angles.
    """
    raw = folder / RAW_FOLDER
    return create_project(
        folder,
        trajectory=raw / TRAJECTORY_FILE,
        lines=[LineSource(name, raw / f"{name}.laz") for name in lines],
        accuracy=raw / ACCURACY_FILE,
        settings=settings,
        truth_deg=as_triple(truth_deg),
    )


def require_replaceable(folder: Path, marker: str) -> None:
    """Refuse a folder that contains anything other than an earlier survey of this kind.

    Raises
    ------
    ProjectError
        If the path is a file, the folder has other content, or one of its folders is a link.
    """
    if folder.exists() and not folder.is_dir():
        raise ProjectError(error("simulate.folder_is_file", folder=str(folder)))
    names = [path.name for path in folder.iterdir()] if folder.exists() else []
    is_foreign = any(not _UNFINISHED_FOLDER_PATTERN.fullmatch(name) for name in names)
    if is_foreign and not (folder / RAW_FOLDER / marker).is_file():
        raise ProjectError(error("simulate.folder_in_use", folder=str(folder)))
    require_no_link(folder / RAW_FOLDER, folder / TRUTH_FOLDER, folder / SIGHTINGS_FOLDER)


@contextmanager
def replaced_survey(
    folder: Path, marker: str, text: str, parts: Sequence[str] = ()
) -> Iterator[Path]:
    """Yield an empty folder for the files of a new survey, which replace those of the earlier one.

    The files are moved into ``folder`` when all have been written. After an error, the earlier
    survey remains unchanged.

    Parameters
    ----------
    marker : str
        Name of the file that marks the survey as one that may be replaced.
    text : str
        Content of that file.
    parts : sequence of str
        Files of the earlier survey to remove in addition to the project, the trajectory and the
        lines; files of the user are kept.

    Raises
    ------
    InputError
        If a file cannot be written.
    """  # noqa: DOC501 - `write_error` makes an InputError
    present = [each for each in (folder, *folder.parents) if each.exists()]
    made = [each for each in (folder, *folder.parents) if each not in present]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for path in folder.iterdir():
            if (
                _UNFINISHED_FOLDER_PATTERN.fullmatch(path.name)
                and path.is_dir()
                and not path.is_symlink()
            ):
                shutil.rmtree(path, ignore_errors=True)  # of an interrupted run
        new = Path(mkdtemp(prefix=".survey-", suffix=".part", dir=folder))
    except ValueError as failure:
        raise bad_name_error(folder) from failure
    except OSError as failure:
        remove_empty_folders(made)
        raise write_error(folder, failure) from failure
    try:
        with atomic_write(new / RAW_FOLDER / marker) as path:
            path.write_text(text, encoding="utf-8")
        yield new
        _remove_earlier(folder, parts)
        for path in sorted(path for path in new.rglob("*") if path.is_file()):
            place = folder / path.relative_to(new)
            place.parent.mkdir(exist_ok=True)
            path.replace(place)
    except OSError as failure:
        raise write_error(folder, failure) from failure
    finally:
        shutil.rmtree(new, ignore_errors=True)
        remove_empty_folders(made)


def _remove_earlier(folder: Path, parts: Sequence[str]) -> None:
    """Remove the files that an earlier simulation wrote."""
    raw = [f"{RAW_FOLDER}/{name}" for name in (TRAJECTORY_FILE, ACCURACY_FILE)]
    for path in (*_earlier_line_files(folder), *(folder / name for name in (*raw, *parts))):
        if path.is_file() or path.is_symlink():
            path.unlink()
    (folder / PROJECT_FILE_NAME).unlink(missing_ok=True)
    remove_point_files(folder)


def _earlier_line_files(folder: Path) -> list[Path]:
    """Files in the folder ``raw`` that the project of an earlier simulation has as its lines."""
    try:
        lines = json_values((folder / PROJECT_FILE_NAME).read_bytes())["lines"]
        names = [PurePosixPath(line["path"]) for line in lines]
    except (OSError, ValueError, KeyError, TypeError):
        return []
    return [folder / name for name in names if name.parts == (RAW_FOLDER, name.name)]


def write_lines(
    survey: SimulatedSurvey, raw: Path, *, progress: Progress = no_progress
) -> list[LineSource]:
    """Write each line in the scanner frame, with time and intensity."""
    lines = []
    for k, line in enumerate(survey.lines):
        progress(k / len(survey.lines), gettext_lazy("Writing {line}", line=line.name))
        path = raw / f"{line.name}.laz"
        write_points(path, line.points_lidar, line.time, line.intensity.astype(float))
        lines.append(LineSource(line.name, path))
    return lines


def write_trajectory(survey: SimulatedSurvey, raw: Path) -> tuple[Path, Path]:
    """Write SBET and smrmsg, and return their paths."""
    sbet, smrmsg = raw / TRAJECTORY_FILE, raw / ACCURACY_FILE
    states = survey.trajectory
    attitude = np.stack([states.roll, states.pitch, states.heading], axis=1)
    # The errors of the POS change so slowly that velocities and rates are almost true.
    velocity, attitude_rate = (
        np.gradient(true, states.time, axis=0)
        for true in (states.true_position_local, states.true_attitude)
    )
    write_sbet(
        sbet,
        Trajectory(
            states.time, states.latitude, states.longitude, states.height, attitude,
            velocity=velocity, attitude_rate=attitude_rate,
        ),
    )  # fmt: skip
    # POSPac writes smrmsg once a second.
    last = len(states.time) - 1
    once = np.append(np.arange(0, last, max(round(1 / states.interval), 1)), last)
    write_smrmsg(
        smrmsg,
        TrajectoryAccuracy(
            states.time[once], states.sigma_position[once], states.sigma_attitude[once]
        ),
    )
    return sbet, smrmsg


def as_triple(values: np.ndarray) -> Triple:
    """Convert ``values``, shape (3,), to three floats."""
    first, second, third = (float(value) for value in values)
    return first, second, third


def _surveyor_settings(simulation: SimulatedSetup) -> Settings:
    """Settings of the surveyor: given lever arm, no boresight, sigmas of the data sheets."""
    latitude, longitude, height = simulation.setup.origin
    scanner = simulation.setup.scanner
    beam = (scanner.range_sigma, float(np.degrees(scanner.angle_sigma)))
    settings = Settings(
        lever_arm=simulation.lever_arm,
        origin_deg_m=(float(np.degrees(latitude)), float(np.degrees(longitude)), height),
        lidar_sigma=max(scanner.range_sigma, 0.001),
        lidar_beam_sigma=beam if min(beam) > 0 else None,
    )
    pos = simulation.setup.pos
    for each in pos.parts if isinstance(pos, CombinedModel) else (pos,):
        if isinstance(each, PosErrorModel):
            position, attitude = each.time_position, each.time_attitude
            return replace(settings, position_time=position, attitude_time=attitude)
    return settings


def _write_truth(
    survey: SimulatedSurvey, simulation: SimulatedSetup, folder: Path, seed: int
) -> None:
    """Write the true mounting, the surface of every point, and the seeds of the targets."""
    latitude, longitude, height = survey.origin
    values = dict(zip(MOUNTING_VALUE_NAMES, survey.mounting.values, strict=True))
    truth = {
        "seed": seed,
        **{kind: {"title": title, "file": simulation.files[kind].name}
           for kind, title in simulation.titles.items()},
        "scanner_settings": encode_value(simulation.setup.scanner),
        "origin_deg_m": [np.degrees(latitude), np.degrees(longitude), height],
        "mounting": {
            "boresight_deg": [np.degrees(values[name]) for name in MOUNTING_VALUE_NAMES[:3]],
            "lever_arm_m": [values[name] for name in MOUNTING_VALUE_NAMES[3:6]],
            "range_offset_m": values["range_offset"],
            "scan_angle_offset_deg": np.degrees(values["scan_angle_offset"]),
            "latency_s": values["latency"],
        },
        "lever_arm_given_m": simulation.lever_arm,
    }  # fmt: skip
    with atomic_write(folder / TRUTH_FILES[0]) as path:
        path.write_text(json.dumps(truth, indent=1) + "\n", encoding="utf-8")
    with atomic_write(folder / TRUTH_FILES[1]) as path:
        labels = {line.name: line.label for line in survey.lines}
        np.savez_compressed(path, surfaces=np.array(survey.surface_names), **labels)  # type: ignore[arg-type]
    for file, spheres in ((TARGET_LIST_FILE, False), (SPHERE_LIST_FILE, True)):
        rows = [
            (name, *seed_local, role)
            for role, seeds in (("target", survey.targets), ("validation", survey.validation))
            for name, seed_local in seeds.items()
            if isinstance(survey.scene[name], Sphere) == spheres
        ]
        if rows:
            columns = [np.array(column) for column in zip(*rows, strict=True)]
            with atomic_write(folder / file) as path:
                names, formats = ("name", "x", "y", "z", "role"), ("s", ".4f", ".4f", ".4f", "s")
                write_table(path, names, columns, formats)
