"""A complete project with invented results, for tests of reports and views."""

from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from lispac.adjustment.model.observations import Sighting
from lispac.adjustment.model.parameters import ParameterEstimate, mounting_value_name
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import (
    AdjustmentResult,
    ChiSquare,
    CrossCheck,
    CrossChecks,
    Observability,
    SightingReliability,
    SightingResidual,
    TargetResidual,
)
from lispac.messages import error, note
from lispac.present.survey.survey_data import LineTrajectorySummary
from lispac.present.targets.surface_geometry import PlaneSection, plane_section
from lispac.project import LineSource, PickedSighting, Project, Settings, Target
from lispac.report.content import ReportContent, report_content
from lispac.report.document_blocks import Block, Group, PictureRow, UndrawnPictures
from lispac.report.options import ReportOptions
from lispac.survey.georeferencing import Mounting
from lispac.targets.surface_geometry import SurfaceGeometry
from lispac.validation.comparison_results import (
    DistanceStatistics,
    PairComparison,
    PairState,
    PlaneComparison,
    SignedStatistics,
)
from lispac.validation.distance_map import DistanceMap
from lispac.validation.distance_profile import DistanceProfile
from lispac.validation.plane_offset import PlaneOffset

FULL_REPORT = ReportOptions(extent="full")
LARGEST_INCREASES = note(
    "observability.largest_increases",
    angles=(
        note("item.sigma_increase", angle=mounting_value_name("roll"), increase=0.184, line="L4"),
    ),
)
HEADINGS = {"L1": 0.4, "L2": 180.2, "L3": 45.1, "L4": 224.7, "L5": 315.3, "L6": 134.8}
MADE = datetime(2025, 6, 4, 14, 3, 20, tzinfo=UTC)


POS_SIGMA = np.array([0.012, 0.012, 0.02, *np.radians([0.008, 0.008, 0.012])])


def _reliability(sighting: SightingResidual, k: int) -> SightingReliability:
    rng = np.random.default_rng(100 + k)
    return SightingReliability(
        sighting=sighting.sighting,
        pos_error=POS_SIGMA * rng.uniform(-1.5, 1.5, 6),
        pos_sigma=POS_SIGMA,
        pos_sigma_after=0.4 * POS_SIGMA,
        shift=float(rng.normal(0, 0.004)),
        w=float(rng.uniform(-2.5, 2.5)),
        detectable=float(rng.uniform(0.02, 0.04)),
        effect=np.radians(rng.normal(0, 0.004, 3)),
        redundancy=float(rng.uniform(0.95, 0.99)),
        outliers=0,
        largest_w=2.9,
        largest_at=416012.375 + k,
        point_detectable=0.0071,
        weight=0.98,
        rejected=False,
    )


def _observability(sigma: np.ndarray, lines: dict[str, float]) -> Observability:
    return Observability(
        eigenvalues=1 / np.sort(sigma)[::-1] ** 2,
        directions=np.eye(3)[:, ::-1],
        condition=5.321,
        sigma_without_line={
            line: None if k == 5 else (1.1 + 0.05 * k) * sigma for k, line in enumerate(lines)
        },
        messages=(
            note(
                "observability.directions",
                weakest=mounting_value_name("yaw"), weakest_sigma=sigma[2],
                strongest=mounting_value_name("roll"), strongest_sigma=sigma[0],
            ),
            LARGEST_INCREASES,
        ),
    )  # fmt: skip


def sample_checks(lines: dict[str, float], targets: tuple[str, ...]) -> CrossChecks:
    """Cross-checks of the sample: all parts agree with the whole; T2 alone has no result."""
    sigma = np.radians([0.0163, 0.0291, 0.0376])
    rng = np.random.default_rng(7)

    def part(kind: str, name: str, angles: np.ndarray) -> CrossCheck:
        whole = np.radians([0.43951, -1.86812, 0.39923])
        ratio = angles / (0.5 * sigma)
        return CrossCheck(kind, name, whole + angles, 1.1 * sigma, angles, ratio)

    halves = rng.normal(0, 0.4, 3) * sigma
    return CrossChecks(
        parts=(
            *(part("line", line, rng.uniform(-0.5, 0.5, 3) * sigma) for line in lines),
            CrossCheck("target", targets[0], reason=error("adjustment.parallel_planes")),
            part("target", targets[1], rng.uniform(-0.5, 0.5, 3) * sigma),
            part("half", "first", halves),
            part("half", "second", -halves),
        ),
    )


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
    correlated = model == "correlated"
    # The lever arm is estimated too, with small correlations to the angles
    wider = np.eye(4)
    wider[:3, :3] = correlation
    wider[3, :3] = wider[:3, 3] = (0.031, -0.127, 0.208)
    sigma_all = np.array([*sigma, 0.0048])
    lever = ParameterEstimate("lever_x", -0.1856, None, -0.2017, 0.0048, -3.354)
    return AdjustmentResult(
        mounting=Mounting(np.zeros(3), np.radians([0.43951, -1.86812, 0.39923])),
        prior_boresight=np.radians([0.0, -1.5, 0.0]),
        estimated=("roll", "pitch", "yaw", "lever_x") if correlated else ("roll", "pitch", "yaw"),
        covariance_all=wider * np.outer(sigma_all, sigma_all)
        if correlated
        else correlation * np.outer(sigma, sigma),
        parameters=(lever,) if correlated else (),
        path=np.radians([[0.0, -1.5, 0.0], [0.4, -1.9, 0.4], [0.43951, -1.86812, 0.39923]]),
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
                np.array([0.0, np.cos(lean), np.sin(lean), 15.0]),
                vessel_side=1,
            )
            for target, lean in zip(targets, (0.0, -np.pi / 4), strict=True)
        ),
        sightings=sightings,
        rms_before=0.05234,
        rms_after=0.00301,
        surface=0.0004 if correlated else 0.0,
        observability=_observability(sigma, lines),
        reliability=tuple(_reliability(s, k) for k, s in enumerate(sightings))
        if correlated
        else (),
        components=(),
        elapsed=0.0123,
    )


def _plane(name: str, scale: float, pairs: tuple[tuple[str, str, bool], ...]) -> PlaneComparison:
    rng = np.random.default_rng(int(name[-1]))
    before = np.abs(rng.normal(scale, scale / 3, 9000))
    after = np.abs(rng.normal(0, 0.006, 9000))
    edges = np.linspace(0, float(np.percentile(before, 99.5)), 61)
    counts = [np.histogram(np.minimum(d, edges[-1]), edges)[0] for d in (before, after)]
    statistics = [DistanceStatistics.of(d) for d in (before, after)]
    states = [
        PairState(
            distances,
            SignedStatistics(400, off, off, 0.002, 0.0011, share, float(np.hypot(off, 0.002))),
            PlaneOffset(off, 0.0002, tilt, 1e-5, -tilt / 3, 2e-5, 3),
        )
        for distances, off, share, tilt in zip(
            statistics, (-scale, 0.0012), (0.98, 0.31), (8e-4, 3e-5), strict=True
        )
    ]
    steps = np.linspace(1.0, 40.0, 13)
    profile = DistanceProfile(
        steps, np.full(12, 750), scale * steps[1:] / 40, np.full(12, 0.004),
        scale * steps[1:] / 20, np.full(12, 0.012),
    )  # fmt: skip
    return PlaneComparison(
        name=name,
        pairs=tuple(PairComparison(a, b, r, *states) for a, b, r in pairs),
        not_compared=(("L1", "L6"),),
        pooled_from="reciprocal pairs",
        bin_edges=edges,
        counts_before=counts[0].astype(np.int64),
        counts_after=counts[1].astype(np.int64),
        before=statistics[0],
        after=statistics[1],
        by_height=profile,
        by_range=None if name == "V3" else profile,
        maps=() if name == "V3" else tuple(_map(a, b, scale) for a, b, _ in pairs[:2]),
    )


def _map(line_a: str, line_b: str, scale: float) -> DistanceMap:
    """Map of 3 m by 1.5 m with distances that grow to the right, and one missing corner."""
    across, up = (v.ravel()[1:] for v in np.meshgrid(np.arange(0.25, 3, 0.5), (0.25, 0.75, 1.25)))
    return DistanceMap(line_a, line_b, 0.5, across, up, -scale * across, 0.001 * up)


def _on_every_line(k: int) -> tuple[PickedSighting, ...]:
    """Sightings of the ``k``-th target, without points shared with other targets."""
    numbers = np.arange(200 * k, 200 * (k + 1))
    return tuple(PickedSighting(line, numbers, 0.003) for line in HEADINGS)


def sample_project(folder: Path, *, model: str = "correlated", target: str = "T1") -> Project:
    """A complete project with invented results."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("trajectory.sbet", "smrmsg.out", *(f"{line}.laz" for line in HEADINGS)):
        (folder / name).write_bytes(name.encode() * 1000)
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
            Target(name, role, seed, 0.015, 1.0, _on_every_line(k))  # type: ignore[arg-type]
            for k, (name, role, seed) in enumerate(picked)
        ),
        result=_result(HEADINGS, (target, "T2"), model),
        cross_checks=sample_checks(HEADINGS, (target, "T2")),
        validation=(_plane("V1", 0.04, pairs), _plane("V2", 0.09, pairs), _plane("V3", 0.4, pairs)),
    )


def sample_content(
    project: Project, generated: datetime = MADE, convention: str = ""
) -> ReportContent:
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
        notes=(note("assumed.time_base", base=note("time_base.gps_week")),),
        generated=generated,
        convention=convention,
        trajectory=[
            LineTrajectorySummary(
                line, 81.2, 1.54, 0.005, 0.010, (1.21, 0.63), 0.017, 0.02, 0.008, 0.012
            )
            for line in HEADINGS
        ],
        geometries={
            target.name: SurfaceGeometry(np.array(target.seed), TOWARDS_EAST, np.array([2.4, 1.2]))
            for target in project.targets
        },
        plane_sections=[_section(plane.name) for plane in project.validation],
    )


TOWARDS_EAST = np.array([0.0, -1.0, 0.0])


def _section(plane: str) -> PlaneSection:
    """Section with 20 points of each line, the lines 10 mm apart before and 1 mm after."""
    along = np.linspace(-1.2, 1.2, 20)
    before, after = (
        {line: np.column_stack([along, np.full(20, k * step)]) for k, line in enumerate(HEADINGS)}
        for step in (0.01, 0.001)
    )
    return plane_section(plane, "Up (m)", {x: k for k, x in enumerate(HEADINGS)}, before, after)


def with_lines_of_its_own(project: Project) -> Project:
    """Another survey, whose lines are not copies of those of another sample."""
    for line in project.lines:
        line.path.write_bytes(str(line.path).encode() * 100)
    return project


def undrawn_pictures(blocks: Iterable[Block]) -> Iterator[UndrawnPictures]:
    """Yield the figures of a report, also those in rows and groups."""
    for block in blocks:
        if isinstance(block, Group):
            yield from undrawn_pictures(block.blocks)
            continue
        pictures = block.pictures if isinstance(block, PictureRow) else (block,)
        yield from (each for each in pictures if isinstance(each, UndrawnPictures))
