"""Small sites with simulated points, labelled with the surface they are on."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from lispac.geometry.frames import LocalFrame
from lispac.project import LineSource, Project, Settings
from lispac.simulation.port_scene import LOCAL_ORIGIN, six_lines
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.simulation.scanner import Echoes, Scanner, scan_scene
from lispac.simulation.scene import Rectangle, Scene, Surface, tilted_rectangle
from lispac.simulation.simulated_survey import BORESIGHT_DEG, LEVER_ARM
from lispac.simulation.vessel_motion import SAMPLE_RATE, sail_lines
from lispac.survey.cloud import CloudInMemory
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.scan import Scan
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.workflow.project.survey import Survey

WALL = -15.0  # metres west: 15 m to starboard of the line along it
REACH = 7.0  # recorded metres before and after the middle is abeam
NEAR = 7.0  # metres around the targets: points farther away only take time


@dataclass(frozen=True, eq=False)
class Site:
    """Simulated lines past a scene, with their true values."""

    scene: Scene
    boresight: np.ndarray
    trajectory: LocalTrajectory
    echoes: Mapping[str, Echoes]

    def clouds(self, off_deg: Iterable[float] = (0.0, 0.0, 0.0)) -> dict[str, np.ndarray]:
        """Every line, georeferenced with a boresight that is wrong by ``off_deg``."""
        mounting = Mounting(np.array(LEVER_ARM), self.boresight + np.radians(off_deg))
        return {
            name: georeference(echo.points_lidar, echo.time, self.trajectory, mounting)
            for name, echo in self.echoes.items()
        }

    def on(self, line: str, *names: str) -> np.ndarray:
        """Mask of the points of a line on the surfaces with these names."""
        labels = [k for k, name in enumerate(self.scene.names) if name in names]
        return np.isin(self.echoes[line].label, labels)

    def opened(
        self, off_deg: Iterable[float] = (0.0, 0.0, 0.0), *, noise: float = 0.002
    ) -> tuple[Project, Survey]:
        """Project of these lines with a prior boresight wrong by ``off_deg``, and its survey."""
        prior = np.degrees(self.boresight) + list(off_deg)
        settings = Settings(
            lever_arm=LEVER_ARM, boresight_deg=tuple(map(float, prior)), lidar_sigma=noise
        )
        project = Project(
            folder=Path("site"), trajectory=Path("site.sbet"),
            lines=tuple(LineSource(name, Path(f"{name}.laz")) for name in self.echoes),
            settings=settings,
        )  # fmt: skip
        scans = {name: Scan(echo.points_lidar, echo.time) for name, echo in self.echoes.items()}
        mounting = project.mounting("prior")
        clouds = {
            name: CloudInMemory.of(scan, self.trajectory, mounting) for name, scan in scans.items()
        }
        heading = {
            name: float(np.median(self.trajectory.at(scan.time).attitude[:, 2]))
            for name, scan in scans.items()
        }
        accuracy = TrajectoryAccuracy.constant(
            np.array(settings.used_position_sigma), np.radians(settings.used_attitude_sigma_deg)
        )
        return project, Survey(self.trajectory, accuracy, scans, clouds, heading, ())

    def points_lidar(self, line: str) -> np.ndarray:
        return self.echoes[line].points_lidar


def site(
    surfaces: Sequence[Surface],
    *,
    lines: int = 6,
    seed: int = 11,
    pulses_per_second: float = 100_000.0,
    absent_from: str | None = None,
    near: float = NEAR,
) -> Site:
    """Simulate the first of six lines past a scene, with POS errors, noise and mixed echoes.

    T1 is missing on the line ``absent_from``. Points farther than ``near``, metres, from the middle
    of the targets are omitted.
    """
    sea, errors, *scanners = np.random.default_rng(seed).spawn(2 + lines)
    lines = [replace(each, run_in=REACH, run_out=REACH) for each in six_lines()[:lines]]
    motion = sail_lines(lines, 1.1, sea)
    off_position, off_attitude = HYDROGRAPHIC_INS.draw(len(motion.time), 1 / SAMPLE_RATE, errors)
    states = (motion.time, motion.position, motion.attitude)
    scene, boresight = Scene.of(surfaces), np.radians(BORESIGHT_DEG)
    middle = np.mean([s.centre for s in scene.surfaces if s.name.startswith("T")], axis=0)
    without = Scene.of([s for s in surfaces if s.name != "T1"])
    echoes = {}
    for k, (each, recorded) in enumerate(zip(lines, motion.recorded, strict=True)):
        absent = absent_from == f"L{k + 1}"
        shown = without if absent else scene
        whole = scan_scene(
            Scanner(pulses_per_second), shown, states, recorded, each.starboard,
            Mounting(np.array(LEVER_ARM), boresight), scanners[k],
        )  # fmt: skip
        kept = np.linalg.norm(whole.true_points_local - middle, axis=1) < near
        echoes[f"L{k + 1}"] = Echoes(
            whole.time[kept], whole.points_lidar[kept], whole.true_points_local[kept],
            whole.intensity[kept], whole.label[kept] + (absent and whole.label[kept] >= 0),
        )  # fmt: skip
    trajectory = LocalTrajectory(
        LocalFrame(*LOCAL_ORIGIN),
        motion.time,
        motion.position + off_position,
        motion.attitude + off_attitude,
    )
    return Site(scene, boresight, trajectory, echoes)


def rippled(
    name: str, centre: tuple[float, float, float], width: float, height: float, *,
    period: float = 0.2, slope_deg: float = 12.0,
) -> list[Rectangle]:  # fmt: skip
    """A corrugated sheet facing east, of strips with alternating inclination."""
    strip = period / 2
    half = np.radians(slope_deg)
    return [
        tilted_rectangle(
            name,
            (float(north), centre[1], centre[2]),
            strip / float(np.cos(half)),
            height,
            270 + slope_deg * (-1) ** k,
            0,
        )
        for k, north in enumerate(centre[0] + np.arange(-width / 2 + strip / 2, width / 2, strip))
    ]


def precision_and_recall(indices: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Share of the found points that are right, and share of the right points that are found."""
    right = np.count_nonzero(truth[indices])
    return right / max(len(indices), 1), right / max(np.count_nonzero(truth), 1)
