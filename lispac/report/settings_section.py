"""The section on settings: the stochastic model in words, what was stated, and the input files."""

from lispac.report.blocks import Block, Bullets, Column, Paragraph, Table, facts, rows
from lispac.report.values import Adjustment, ReportContent, SettingsUsed, VarianceComponent
from lispac.report.wording import (
    known,
    listed,
    mm,
    origin,
    parameter,
    quantity,
    surface_sigmas,
    times,
    title,
    triple,
)

NOTEWORTHY_NOISE = 1.05
"""Smallest factor on the stated LiDAR noise that is written as more than 1.0."""


def settings(content: ReportContent) -> list[Block]:
    """Everything that was stated of system, points and stochastic model."""
    used, adjustment = content.settings, content.adjustment
    blocks: list[Block] = [
        facts("System and points", _system(used, adjustment)),
        facts("Stochastic model", _model(used, adjustment)),
    ]
    if adjustment is not None and adjustment.components:
        blocks += _components(adjustment)
    blocks.append(_files(content))
    if content.notes:
        blocks += [Paragraph("Input assumptions:"), Bullets(content.notes)]
    return blocks


def _system(used: SettingsUsed, adjustment: Adjustment | None) -> list[tuple[str, str]]:
    names = [p.name for p in adjustment.parameters] if adjustment else []
    prior = "Prior lever arm" if any(name.startswith("lever") for name in names) else "Lever arm"
    said = [
        (f"{prior}, forward, left, up", f"{triple(used.lever_arm_m, 4)} m"),
        ("Origin of the local frame", origin(used.origin_deg_m)),
    ]
    for name, value in (
        ("range_offset", used.range_offset_m),
        ("scan_angle_offset", used.scan_angle_offset_deg),
        ("latency", used.latency_s),
    ):
        if value:
            said.append((f"{title(parameter(name))}, as stated", quantity(name, value, sign=True)))
    if names:
        also = listed([parameter(name) for name in names])
        said.append(("Asked to be estimated", f"the boresight; {also}"))
    if used.accept_one_facing:
        said.append(("Targets that all face one way", "accepted"))
    return [*said, ("Subsampling", _subsampling(used))]


def _subsampling(used: SettingsUsed) -> str:
    if not used.subsample_m:
        return "none: all points take part"
    if used.averaged:
        return (
            f"averaged: neighbours on a plane within a square of {used.subsample_m:.3f} m make one "
            "point; points of spheres stay as they are"
        )
    return f"selected: of neighbours within {used.subsample_m:.3f} m one is kept"


def _model(used: SettingsUsed, adjustment: Adjustment | None) -> list[tuple[str, str]]:
    accuracy = "from the trajectory accuracy file"
    said = [
        ("POS errors", f"{used.pos_errors}. {used.pos_errors_in_words}"),
        (
            "Position sigma, north, east, down",
            f"{triple(used.position_sigma_m, 3)} m" if used.position_sigma_m else accuracy,
        ),
        (
            "Attitude sigma, roll, pitch, heading",
            f"{triple(used.attitude_sigma_deg, 4)} deg" if used.attitude_sigma_deg else accuracy,
        ),
    ]
    if used.position_correlation_time_s and used.attitude_correlation_time_s:
        said.append(
            (
                "Correlation times, position, attitude",
                f"{used.position_correlation_time_s:g} s, {used.attitude_correlation_time_s:g} s: "
                "how long a POS error lasts. Take those of the processing report where it states "
                "them; too short a time is safer than too long a one.",
            )
        )
    said.append(("LiDAR noise, 1 sigma", _lidar(used)))
    if adjustment is not None and used.pos_errors == "correlated":
        said.append(("LiDAR noise found", _noise(adjustment)))
    if used.surface_from_data is not None:
        said.append(("Surface sigma", _surface(used)))
    return [*said, ("Stray points", f"loss: {used.loss}. {used.loss_in_words}")]


def _lidar(used: SettingsUsed) -> str:
    if used.lidar_range_sigma_m is not None and used.lidar_angle_sigma_deg is not None:
        return (
            f"range {mm(used.lidar_range_sigma_m)} mm, direction of the beam "
            f"{used.lidar_angle_sigma_deg:.4f} deg"
        )
    if used.lidar_sigma_xyz_m is not None:
        x, y, z = (mm(value) for value in used.lidar_sigma_xyz_m)
        return f"x {x} mm, y {y} mm, z {z} mm"
    return f"{mm(used.lidar_sigma_m)} mm on each axis"


def _noise(adjustment: Adjustment) -> str:
    larger = [t for t in adjustment.targets if t.noise_factor >= NOTEWORTHY_NOISE]
    stated = (
        "the sigma found by the variance components"
        if any(c.applied and c.name == "LiDAR" for c in adjustment.components)
        else "the stated LiDAR noise"
    )
    if not larger:
        return f"not above {stated} on any target"
    found = listed([f"{times(t.noise_factor)} ({t.target})" for t in larger])
    return f"in the residuals {found} {stated}; the sigmas of the angles are computed with it"


def _surface(used: SettingsUsed) -> str:
    what = "how far a sighting as a whole may lie off the shape that all lines have in common"
    if used.surface_sigma_m is None:
        return f"to be found from the data: {what}"
    if used.surface_sigma_m == 0:
        return "none: each sighting is held to the shape that all lines have in common"
    source = "found from the data" if used.surface_from_data else "as typed"
    return f"{surface_sigmas(used.surface_sigma_m, used.offset_sigma_m)}, {source}: {what}"


def _components(adjustment: Adjustment) -> list[Block]:
    return [
        Table(
            "Variance components: the sigmas by the data, over the stated ones",
            (
                Column("Errors of", "left"),
                Column("Factor"),
                Column("95 % interval"),
                Column("Finding", "left"),
            ),
            rows(_component(component) for component in adjustment.components),
        ),
        Paragraph(
            "From the residuals and the estimated POS errors by restricted likelihood. A sigma is "
            "raised where the data say more, and lowered only where the whole interval says less; "
            "what is not applied is used as stated. With few sightings the data say little of the "
            "POS: a wide interval means that the stated sigma may be as good as the one found."
        ),
    ]


def _component(found: VarianceComponent) -> tuple[str, str, str, str]:
    interval = f"{found.lower:.2f} to {found.upper:.2f}"
    return found.name, f"{found.factor:.2f}", interval, found.in_words


def _files(content: ReportContent) -> Table:
    return Table(
        "Input files",
        (
            Column("Use", "left"),
            Column("File", "left"),
            Column("Bytes"),
            Column("SHA-256", "left", code=True),
        ),
        rows(
            [
                file.role,
                file.name,
                known(file.size_bytes, lambda v: f"{v:,.0f}"),
                file.sha256 or "not readable",
            ]
            for file in content.files
        ),
    )
