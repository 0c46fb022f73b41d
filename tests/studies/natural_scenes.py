"""Coverage of the sigmas with proposed targets in random scenes without boards.

    python -m tests.studies.natural_scenes [SCENES]

Roofs, walls, ground, vehicles and tarpaulins of random size, inclination and form error, seen from
two to six lines. Prints the number of scenes with proposed targets, the share of 95 % intervals
that contain the truth, for each angle, the ratio of reported and predicted sigmas, and the serious
warnings.
`tests.studies.false_warnings` prints the same, and which of the warnings are false.
"""

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from lispac.duplicate_targets import all_warnings
from lispac.errors import AdjustmentError, TargetNotFound
from lispac.geometry.planes import fit_plane, plane_axes, rms_distance
from lispac.messages import Message
from lispac.project import Project
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.simulation.scanner import Echoes
from lispac.simulation.scene import Rectangle, tilted_rectangle
from lispac.simulation.simulated_survey import LEVER_ARM
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import TrajectoryAccuracy
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.proposal_acceptance import with_accepted_targets
from lispac.workflow.calibration.proposals import propose_targets
from lispac.workflow.project.survey import Survey
from tests.support.finder_scenes import WALL, Site, site

FORMS = {"flat": 0.4, "bent": 0.3, "rough": 0.3}
"""Kinds of surfaces and their probabilities."""
PULSES_PER_SECOND = 60_000.0
WAVELENGTH = 0.8
HALF_WAVE = WAVELENGTH / 2
"""Half of the typical wavelength of a rough surface, metres. Points within this distance share a
form error; on a bent surface the distances are longer."""


def surfaces(chance: np.random.Generator) -> list[Rectangle]:
    """Six to fourteen surfaces; the first two are the ground and a wall."""
    found = [
        tilted_rectangle("T-ground", (0.0, WALL - 3.0, 4.0), 14.0, 8.0, 270, 85),
        tilted_rectangle(
            "T-wall", (chance.uniform(-3, 3), WALL - 5.0, 7.0), 6.0, 5.0,
            chance.uniform(240, 300), 0,
        ),
    ]  # fmt: skip
    for k in range(chance.integers(4, 13)):
        centre = (chance.uniform(-5, 5), WALL - chance.uniform(-2, 4), chance.uniform(4.5, 9.5))
        width, height = np.exp(chance.uniform(np.log(0.7), np.log(3.5), 2))
        facing, elevation = 270 + chance.normal(0, 35), abs(chance.normal(0, 35))
        found.append(tilted_rectangle(f"T{k}", centre, width, height, facing, min(elevation, 80.0)))
    return found


def formed(
    echoes: Echoes, beams_local: np.ndarray, scene: list[Rectangle], chance: np.random.Generator
) -> Echoes:
    """Echoes of surfaces that are not flat; every line shows the same shape.

    Parameters
    ----------
    beams_local : ndarray of shape (n, 3), unit vectors, local frame
    """
    along = np.zeros(len(echoes.time))
    beams = echoes.points_lidar / np.linalg.norm(echoes.points_lidar, axis=1)[:, None]
    for k, surface in enumerate(scene):
        own = echoes.label == k
        place = echoes.true_points_local[own] - surface.centre
        up = np.cross(surface.normal, surface.across)
        u, v = place @ surface.across, place @ up
        form = chance.choice(list(FORMS), p=list(FORMS.values()))
        bends, phases = chance.normal(0, 1, 3), chance.uniform(0, 2 * np.pi, (6, 2))
        waves = 2 * np.pi * chance.normal(0, 1 / WAVELENGTH, (6, 2))
        size = np.exp(chance.uniform(np.log(0.005), np.log(0.06)))
        off = np.zeros(len(u))
        if form == "bent":
            shape = bends[0] * u**2 + bends[1] * u * v + bends[2] * v**2
            off = size * shape / (np.abs(bends).sum() * max(surface.width, surface.height) ** 2 / 4)
        elif form == "rough":
            for wave, phase in zip(waves, phases, strict=True):
                off += size / 6 * np.sin(wave[0] * u + wave[1] * v + phase[0])
        # Along the beam as far as the surface is displaced along its normal.
        along[own] = off / np.maximum(np.abs(beams_local[own] @ surface.normal), 0.1)
        along[own] *= -np.sign(beams_local[own] @ surface.normal)
    return replace(
        echoes,
        points_lidar=echoes.points_lidar + along[:, None] * beams,
        true_points_local=echoes.true_points_local + along[:, None] * beams_local,
    )


def natural_site(seed: int) -> Site:
    """Random scene of a seed with two, four or six lines past it."""
    chance = np.random.default_rng([34, seed])
    scene = surfaces(chance)
    scene_site = site(
        scene,
        lines=int(chance.choice([2, 4, 6])),
        seed=seed,
        pulses_per_second=PULSES_PER_SECOND,
        near=9.0,
    )
    forms = int(chance.integers(2**31))
    mounting = Mounting(np.array(LEVER_ARM), scene_site.boresight)
    echoes = {}
    for name, each in scene_site.echoes.items():
        near, far = (
            georeference(scale * each.points_lidar, each.time, scene_site.trajectory, mounting)
            for scale in (1.0, 1.1)
        )
        beams = (far - near) / np.linalg.norm(far - near, axis=1)[:, None]
        echoes[name] = formed(each, beams, scene, np.random.default_rng(forms))
    return replace(scene_site, echoes=echoes)


def opened(scene_site: Site, off_deg: np.ndarray) -> tuple[Project, Survey]:
    """Project and survey with the simulated standard deviations of the POS."""
    project, survey = scene_site.opened(off_deg)
    position, attitude = HYDROGRAPHIC_INS.sigma_position, HYDROGRAPHIC_INS.sigma_attitude
    degrees = tuple(float(np.degrees(each)) for each in attitude)
    settings = replace(project.settings, position_sigma=position, attitude_sigma_deg=degrees)
    accuracy = TrajectoryAccuracy.constant(np.array(position), np.array(attitude))
    return project.with_settings(settings), replace(survey, accuracy=accuracy)


def form_factors(scene_site: Site, project: Project) -> dict[str, float]:
    """Ratio of the form error of each true target surface to the averaged LiDAR noise.

    The error is the RMS distance of the true places of its points from their best plane. Points on
    another surface do not count. Points that share a form error do not share their noise: it
    averages out. A surface is not flat from 1 on.
    """
    noise, side = project.settings.used_lidar_sigma, HALF_WAVE
    found = {}
    for target in project.targets_of_role("target"):
        labels = {s.line: scene_site.echoes[s.line].label[s.indices] for s in target.sightings}
        own = np.bincount(np.concatenate([each[each >= 0] for each in labels.values()])).argmax()
        places = [
            scene_site.echoes[s.line].true_points_local[s.indices[labels[s.line] == own]]
            for s in target.sightings
        ]
        plane = fit_plane(np.concatenate(places))
        cells = sum(
            len(np.unique(np.floor(each @ plane_axes(plane.normal).T / side), axis=0))
            for each in places
        )
        averaged = noise / np.sqrt(sum(map(len, places)) / cells)
        found[target.name] = rms_distance(plane, np.concatenate(places)) / float(averaged)
    return found


@dataclass(frozen=True)
class SceneResult:
    """Result of a scene: only a reason, or error and sigmas in degrees, shape (3,).

    Attributes
    ----------
    warnings : tuple of Message
        The serious ones.
    bent : frozenset of str
        Targets that are not flat by the simulated surface.
    """

    reason: str = ""
    error: np.ndarray | None = None
    sigma: np.ndarray | None = None
    predicted: np.ndarray | None = None
    targets: int = 0
    lines: int = 0
    warnings: tuple[Message, ...] = ()
    bent: frozenset[str] = frozenset()

    @property
    def serious(self) -> tuple[str, ...]:
        """Codes of its serious warnings."""
        return tuple(each.code for each in self.warnings)


def propose_and_adjust(seed: int) -> SceneResult:
    """Propose targets, adjust, and compare the result with the truth."""
    scene_site = natural_site(seed)
    off = np.random.default_rng([35, seed]).normal(0, 1.0, 3)
    project, survey = opened(scene_site, off)
    try:
        proposal = propose_targets(project, survey)
        names = {target.name for target in proposal.targets}
        solved = estimate(with_accepted_targets(project, proposal, names)[0], survey)
    except (TargetNotFound, AdjustmentError) as error:
        return SceneResult(f"{type(error).__name__}: {error}", lines=len(scene_site.echoes))
    result = solved.result
    assert result is not None
    return SceneResult(
        "",
        np.degrees(result.boresight - scene_site.boresight),
        np.degrees(result.sigma),
        np.degrees(proposal.sigma),
        sum(target.role == "target" for target in proposal.targets),
        len(scene_site.echoes),
        tuple(each for each in all_warnings(solved) if each.is_serious),
        frozenset(name for name, each in form_factors(scene_site, solved).items() if each >= 1),
    )


def study(scenes: int, workers: int = 2) -> list[SceneResult]:
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(propose_and_adjust, range(scenes)))


def main() -> None:
    """Print the study."""
    print_results(study(int(sys.argv[1]) if len(sys.argv) > 1 else 200))


def print_results(results: list[SceneResult]) -> None:
    """Print a row for each scene, and the shares."""
    for seed, each in enumerate(results):
        if each.error is None or each.sigma is None:
            print(seed, each.lines, each.reason[:150])
        else:
            print(seed, each.lines, each.targets, np.round(each.error, 3), np.round(each.sigma, 3),
                  np.round(each.error / each.sigma, 1), np.round(each.sigma / each.predicted, 2),
                  each.serious)  # fmt: skip
    for label, selected in (("all", results), ("calm", [a for a in results if not a.serious])):
        known = [a for a in selected if a.error is not None]
        hits = np.mean([np.abs(a.error) < 1.96 * a.sigma for a in known], axis=0)
        ratio = np.median([a.sigma / a.predicted for a in known], axis=0)
        print(f"{label}: {len(known)} of {len(results)} scenes; intervals that hold {100 * hits}; "
              f"stated over predicted {ratio}")  # fmt: skip
    print(Counter(code for each in results for code in each.serious))


if __name__ == "__main__":
    main()
