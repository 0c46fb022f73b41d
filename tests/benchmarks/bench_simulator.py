"""Ranges and points per second of the simulator; run with ``pytest tests/benchmarks``.

All methods use the same beams in one run, so that the ratios are valid on a busy machine too. Rays
on surfaces with a formula are cast in one thread, as within one line; Open3D uses all cores.
"""

from collections.abc import Callable
from time import perf_counter

import numpy as np

from lispac.simulation.closed_form_ranges import beam_rays, range_to_plane
from lispac.simulation.port_scene import port_scene
from lispac.simulation.scanner import scan_scene
from lispac.simulation.scene import Rectangle, Scene, tilted_rectangle
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses
from lispac.workflow.planning.simulated_setup import read_simulation
from tests.simulation.test_meshes import as_mesh

COUNT = 1_000_000
MOUNTING = Mounting(np.array([-0.24, 0.06, 2.17]), np.radians([0.3, -1.1, 0.4]), 0.01, 0.002)
BOARD = tilted_rectangle("board", (0.0, -15.0, 6.0), 400.0, 400.0, 270, 20)


def median_time(work: Callable[[], object], times: int = 5) -> float:
    """Median time of some runs, s, after a first run that compiles."""
    work()
    seconds = []
    for _ in range(times):
        start = perf_counter()
        work()
        seconds.append(perf_counter() - start)
    return float(np.median(seconds))


def beams() -> tuple[np.ndarray, Poses]:
    generator = np.random.default_rng(1)
    angle = generator.uniform(2 * np.pi / 3, np.pi, COUNT)
    directions = np.stack([np.zeros(COUNT), np.cos(angle), np.sin(angle)], axis=1)
    position = generator.uniform(-3, 3, (COUNT, 3)) * [3, 0.1, 0.1]
    return directions, Poses(position, generator.normal(0, 0.01, (COUNT, 3)))


def test_ranges_in_closed_form_and_cast() -> None:
    directions, poses = beams()
    plane = np.array([*BOARD.normal, -BOARD.normal @ BOARD.centre])
    origins, cast = beam_rays(directions, poses, MOUNTING)
    scenes = {
        "cast, one board": Scene.of([BOARD]),
        "cast, one board of 72 triangles": Scene.of([as_mesh(BOARD)]),
        "cast, port": port_scene(),
        "cast, port of triangles": Scene.of(
            [
                as_mesh(surface) if isinstance(surface, Rectangle) else surface
                for surface in port_scene().surfaces
            ]
        ),
    }  # fmt: skip
    formula = median_time(lambda: range_to_plane(plane, directions, poses, MOUNTING))
    print(f"\n{'closed form, with its beams':34s} {COUNT / formula / 1e6:7.2f} M/s")
    turned = median_time(lambda: beam_rays(directions, poses, MOUNTING))
    print(f"{'  of this, beams':34s} {COUNT / turned / 1e6:7.2f} M/s")
    for name, scene in scenes.items():
        seconds = median_time(lambda scene=scene: scene.intersect(origins, cast, 90.0))
        print(f"{name:34s} {COUNT / seconds / 1e6:7.2f} M/s, {formula / seconds:5.2f} closed forms")


def test_lines() -> None:
    """Simulate whole lines in one thread, with noise; print pulses and points per second."""
    for name in ("port", "marine", "terrestrial"):
        setup = read_simulation(name).setup
        motion = setup.motion_source.motion(np.random.default_rng(1))
        states = (motion.time, motion.position, motion.attitude)
        recorded, side = motion.recorded[0], setup.motion_source.legs[0].starboard
        pulses = len(setup.scanner.pulses(*recorded, side)[0])

        def line(setup=setup, states=states, recorded=recorded, side=side) -> int:
            generator = np.random.default_rng(2)
            echoes = scan_scene(
                setup.scanner, setup.scene, states, recorded, side, setup.mounting, generator
            )
            return len(echoes.time)

        points = line()
        seconds = median_time(line, 3)
        print(
            f"\n{name}: {pulses / 1e6:.2f} M pulses, {points / 1e6:.2f} M points, "
            f"{pulses / seconds / 1e6:.2f} M pulses/s, {points / seconds / 1e6:.2f} M points/s"
        )
