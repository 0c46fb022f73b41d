"""A finished project made by hand, for tests of what is shown of one."""

from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from lispac.adjustment.observations import Sighting
from lispac.adjustment.result import AdjustmentResult, ChiSquare, SightingResidual, TargetResidual
from lispac.adjustment.stochastic import StochasticModel
from lispac.project import LineSource, PickedSighting, Project, Settings, Target
from lispac.report.content import ReportContent, report_content
from lispac.validation.results import DistanceStatistics, PairComparison, PlaneComparison

HEADINGS = {"L1": 0.4, "L2": 180.2, "L3": 45.1, "L4": 224.7, "L5": 315.3, "L6": 134.8}
MADE = datetime(2025, 6, 4, 14, 3, 20, tzinfo=UTC)


def _result(lines: dict[str, float], targets: tuple[str, ...], model: str) -> AdjustmentResult:
    rng = np.random.default_rng(1)
    sigma = np.radians([0.0163, 0.0291, 0.0376])
    correlation = np.array([[1, -0.213, 0.547], [-0.213, 1, 0.081], [0.547, 0.081, 1]])
    sightings = tuple(
        SightingResidual(
            Sighting(target, line),
            int(rng.integers(80, 300)),
            float(rng.uniform(0.02, 0.09)),
            float(rng.uniform(0.0025, 0.0035)),
            float(rng.normal(0, 0.0008)),
        )
        for target in targets
        for line in lines
    )
    points = sum(s.points for s in sightings)
    return AdjustmentResult(
        boresight=np.radians([0.43951, -1.86812, 0.39923]),
        prior_boresight=np.radians([0.0, -1.5, 0.0]),
        covariance=correlation * np.outer(sigma, sigma),
        model=StochasticModel(model),  # type: ignore[arg-type]
        variance_factor=1.01234,
        degrees_of_freedom=points - 9,
        chi_square=ChiSquare((points - 9) * 1.01234, (points - 9) * 0.95, (points - 9) * 1.05),
        iterations=5,
        targets=tuple(
            TargetResidual(
                target,
                sum(s.points for s in sightings if s.sighting.target == target),
                0.0541,
                0.00296,
                np.array([0.0, 1.0, 0.0, 15.0]),
            )
            for target in targets
        ),
        sightings=sightings,
        rms_before=0.05234,
        rms_after=0.00301,
        elapsed=0.0123,
    )


def _plane(name: str, scale: float, pairs: tuple[tuple[str, str, bool], ...]) -> PlaneComparison:
    rng = np.random.default_rng(int(name[-1]))
    before = np.abs(rng.normal(scale, scale / 3, 9000))
    after = np.abs(rng.normal(0, 0.006, 9000))
    edges = np.linspace(0, float(np.percentile(before, 99.5)), 61)
    counts = [np.histogram(np.minimum(d, edges[-1]), edges)[0] for d in (before, after)]
    statistics = [DistanceStatistics.of(d) for d in (before, after)]
    return PlaneComparison(
        name=name,
        pairs=tuple(PairComparison(a, b, r, *statistics) for a, b, r in pairs),
        not_compared=(("L1", "L6"),),
        pooled_from="reciprocal pairs",
        bin_edges=edges,
        counts_before=counts[0].astype(np.int64),
        counts_after=counts[1].astype(np.int64),
        before=statistics[0],
        after=statistics[1],
    )


def sample_project(folder: Path, *, model: str = "correlated", target: str = "T1") -> Project:
    """A finished project, made by hand."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("trajectory.sbet", "smrmsg.out", *(f"{line}.laz" for line in HEADINGS)):
        (folder / name).write_bytes(name.encode() * 1000)
    every = tuple(PickedSighting(line, np.arange(200), 0.003) for line in HEADINGS)
    picked = [
        (target, "target", (0.6, -14.7, 5.1)), ("T2", "target", (-1.1, -14.4, 5.3)),
        ("V1", "validation", (28.5, -21.8, 5.4)), ("V2", "validation", (35.0, -21.2, 20.0)),
        ("V3", "validation", (29.5, -24.2, 39.0)),
    ]  # fmt: skip
    pairs = (("L1", "L2", True), ("L3", "L4", True), ("L5", "L6", True), ("L1", "L3", False))
    return Project(
        folder=folder,
        trajectory=folder / "trajectory.sbet",
        accuracy=folder / "smrmsg.out",
        lines=tuple(LineSource(line, folder / f"{line}.laz") for line in HEADINGS),
        settings=Settings((-0.1856, 0.0377, 2.4191), boresight_deg=(0.0, -1.5, 0.0)),
        targets=tuple(
            Target(name, role, seed, 0.015, 1.0, every)  # type: ignore[arg-type]
            for name, role, seed in picked
        ),
        result=_result(HEADINGS, (target, "T2"), model),
        validation=(_plane("V1", 0.04, pairs), _plane("V2", 0.09, pairs), _plane("V3", 0.4, pairs)),
    )


def sample_content(project: Project, generated: datetime = MADE) -> ReportContent:
    along = np.linspace(-40, 40, 9)
    tracks = {
        line: np.stack([along * np.cos(np.radians(h)), -along * np.sin(np.radians(h))], axis=1)
        for line, h in HEADINGS.items()
    }
    return report_content(
        project,
        headings_deg=HEADINGS,
        counts=dict.fromkeys(HEADINGS, 1_234_567),
        track_local=tracks,
        notes=("the SBET times are taken as GPS seconds of week",),
        generated=generated,
    )
