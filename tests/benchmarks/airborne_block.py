"""Simulated airborne survey: houses with gabled roofs on rolling terrain, in six strips.

Three parallel strips in alternating directions and three crossing strips, about 1.8 million points.
"""

from pathlib import Path

import numpy as np

from lispac.project import Project, Settings
from lispac.simulation.meshes import Mesh
from lispac.simulation.motion_source import SailedTrajectory
from lispac.simulation.port_scene import LOCAL_ORIGIN
from lispac.simulation.pos_errors import PosErrorModel
from lispac.simulation.scanner import Scanner
from lispac.simulation.scene import Scene, Sphere, Surface, tilted_rectangle, upright_rectangle
from lispac.simulation.simulated_survey import BORESIGHT_DEG, SurveySetup, simulate_survey
from lispac.simulation.vessel_motion import SailedLine, VesselHandling
from lispac.survey.georeferencing import Mounting
from lispac.workflow.planning.simulate import (
    RAW_FOLDER,
    as_triple,
    create_simulated_project,
    write_lines,
    write_trajectory,
)

FLYING_HEIGHT = 70.0
BLOCK_LENGTH = 240.0
STRIP_DISTANCE = 60.0
LEVER_ARM = (-0.120, 0.045, -0.215)
AIRCRAFT = VesselHandling(
    speed=12.0, speed_abeam=12.0, roll=np.radians(1.2), pitch=np.radians(0.8), heave=0.15
)
INS = PosErrorModel((0.015, 0.015, 0.025), tuple(np.radians([0.004, 0.004, 0.010]).tolist()))
PROFILER = Scanner(
    77_000.0, window=(np.radians(-125.0), np.radians(-55.0)), max_range=150.0, range_sigma=0.008,
    angle_sigma=np.radians(0.003),
)  # fmt: skip
STRIPS = tuple(
    SailedLine(
        np.radians(heading + 180 * (k % 2)),
        (across * STRIP_DISTANCE * (heading > 0), across * STRIP_DISTANCE * (heading == 0)),
        BLOCK_LENGTH / 2, BLOCK_LENGTH / 2, starboard=False, handling=AIRCRAFT,
    )
    for heading in (0, 90)
    for k, across in enumerate((-1, 0, 1))
)  # fmt: skip
HOUSE_INTERVAL = 30.0
GRID_STEP = 1.5
"""Distance between the vertices of the terrain, metres."""
GRASS_ROUGHNESS = 0.03


def terrain_height(north: np.ndarray, west: np.ndarray) -> np.ndarray:
    """Height of the smooth terrain, metres."""
    return np.asarray(
        1.8 * np.sin(2 * np.pi * north / 95.0) * np.cos(2 * np.pi * west / 130.0)
        + 0.6 * np.sin(2 * np.pi * (north + west) / 41.0)
    )


def terrain(half: float, generator: np.random.Generator) -> Mesh:
    """Rolling terrain with grass, so that its triangles are not flat surfaces of some metres."""
    axis = np.arange(-half, half + GRID_STEP, GRID_STEP)
    north, west = np.meshgrid(axis, axis, indexing="ij")
    height = terrain_height(north, west) + generator.normal(0, GRASS_ROUGHNESS, north.shape)
    first = np.add.outer(np.arange(len(axis) - 1) * len(axis), np.arange(len(axis) - 1)).ravel()
    corners = np.stack([first, first + len(axis), first + len(axis) + 1, first + 1], axis=1)
    triangles = np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])
    vertices = np.stack([north, west, height], axis=-1).reshape(-1, 3)
    return Mesh("terrain", vertices, triangles, 0.3)


def house(name: str, north: float, west: float, generator: np.random.Generator) -> list[Surface]:
    """Four walls and a gabled roof with eaves that protrude by 0.4 m."""
    facing, pitch = generator.uniform(0, 180), generator.uniform(25, 45)
    length, width, eaves = generator.uniform([9, 7, 3.0], [15, 10, 6.5])
    ground = float(terrain_height(np.array(north), np.array(west))) - 1.0
    found: list[Surface] = []
    for k in range(4):
        azimuth = np.radians(facing + 90 * k)
        depth, side = (width, length) if k % 2 == 0 else (length, width)
        foot = (north + depth / 2 * np.cos(azimuth), west - depth / 2 * np.sin(azimuth))
        found.append(
            upright_rectangle(
                f"{name} wall {k}", foot, ground, ground + 1 + eaves, side, facing + 90 * k
            )
        )
    slope = (width / 2 + 0.4) / np.cos(np.radians(pitch))
    rise = np.tan(np.radians(pitch)) * width / 2
    for k in range(2):
        azimuth = np.radians(facing + 180 * k)
        off = (width / 2 + 0.4) / 2
        centre = (
            north + off * np.cos(azimuth),
            west - off * np.sin(azimuth),
            ground + 1 + eaves + rise - np.tan(np.radians(pitch)) * off,
        )
        found.append(
            tilted_rectangle(
                f"{name} roof {k}", centre, length + 0.8, slope, facing + 180 * k, 90 - pitch
            )
        )
    return found


def block_scene(seed: int) -> Scene:
    """Terrain, a house and a tree in each cell of a grid."""
    generator = np.random.default_rng([77, seed])
    half = BLOCK_LENGTH / 2 + 90.0
    surfaces: list[Surface] = [terrain(half, generator)]
    middles = np.arange(-BLOCK_LENGTH / 2, BLOCK_LENGTH / 2 + 1, HOUSE_INTERVAL)
    for number, (north, west) in enumerate((n, w) for n in middles for w in middles):
        n, w = np.array([north, west]) + generator.uniform(-3, 3, 2)
        surfaces += house(f"house {number}", float(n), float(w), generator)
        n, w = np.array([north, west]) + HOUSE_INTERVAL / 2 + generator.uniform(-4, 4, 2)
        foot = float(terrain_height(np.array(n), np.array(w)))
        radius = float(generator.uniform(1.5, 3.5))
        surfaces.append(Sphere(f"tree {number}", np.array([n, w, foot + 2 + radius]), radius, 0.2))
    return Scene.of(surfaces)


def make_airborne_block(folder: Path, seed: int = 1) -> Project:
    """Make the project of an airborne survey; scene and errors depend on the seed."""
    setup = SurveySetup(
        LOCAL_ORIGIN, block_scene(seed), (), (), SailedTrajectory(STRIPS, FLYING_HEIGHT), INS,
        PROFILER, Mounting(np.array(LEVER_ARM), np.radians(BORESIGHT_DEG)),
    )  # fmt: skip
    survey = simulate_survey(setup, seed=seed)
    (folder / RAW_FOLDER).mkdir(parents=True)
    write_lines(survey, folder / RAW_FOLDER)
    write_trajectory(survey, folder / RAW_FOLDER)
    latitude, longitude, height = LOCAL_ORIGIN
    settings = Settings(
        lever_arm=LEVER_ARM,
        origin_deg_m=(float(np.degrees(latitude)), float(np.degrees(longitude)), height),
        lidar_beam_sigma=(PROFILER.range_sigma, float(np.degrees(PROFILER.angle_sigma))),
        lidar_sigma=PROFILER.range_sigma,
        boresight_deg=as_triple(np.round(BORESIGHT_DEG)),
        pos_errors="correlated",
    )
    names = [line.name for line in survey.lines]
    return create_simulated_project(folder, names, settings, np.degrees(survey.boresight))
