"""Standard deviations used in an adjustment, and where they come from."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from lispac.adjustment.result import SIGMA_GROUPS, SigmaGroup
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.calibration.parameters import (
    COMPONENT_TITLES,
    VarianceComponentValues,
    interval_text,
)
from lispac.present.tables import Fact, Format
from lispac.present.targets.sightings import PosErrorValues, SightingValues
from lispac.present.text_format import fixed_number, triple_text
from lispac.project import Project

LIDAR_NOISE = Format("mm", 2, 1e3)
"""Format of a LiDAR noise: given with the displayed decimals, the residuals pass their test."""

SigmaSource = Literal["given", "file", "assumed", "estimated"]
"""Source of standard deviations: the user, the accuracy file, a default, or the residuals."""

SIGMA_TITLES: Mapping[SigmaGroup, str] = {
    "LiDAR": N_("LiDAR noise, 1 sigma"),
    "POS position": N_("Position sigma (north, east, down)"),
    "POS attitude": N_("Attitude sigma (roll, pitch, heading)"),
}
SIGMAS_TITLE = N_("Standard deviations used")
_FILE_TEXT = N_("from the trajectory accuracy file")
_FILE_RANGES_TEXT = N_("{values} at the sightings of the targets (from the accuracy file)")
_SCALED_FILE_RANGES_TEXT = N_(
    "{values} at the sightings of the targets ({factor} times those of the accuracy file, "
    "estimated)"
)
_SOURCE_TEXTS: Mapping[SigmaSource, str] = {
    "given": N_("{values} (given)"),
    "assumed": N_("{values} (assumed, not given)"),
    "estimated": N_("{values} (estimated from the residuals)"),
}
_SCALED_FILE_TEXT = N_("{factor} times those of the trajectory accuracy file (estimated)")
_ESTIMATED_TEXTS: Mapping[SigmaSource, str] = {
    "given": N_("{values} (estimated from the data; given: {before})"),
    "assumed": N_("{values} (estimated from the data; assumed before: {before})"),
    "estimated": N_("{values} (estimated from the data; in the estimate before: {before})"),
}
_COMPONENT_TEXTS: Mapping[SigmaSource, str] = {
    "given": N_("{errors}: {factor:x.2} × the given standard deviation = {values}"),
    "assumed": N_("{errors}: {factor:x.2} × the assumed standard deviation = {values}"),
    "file": N_("{errors}: {factor:x.2} × the standard deviations of the accuracy file"),
    "estimated": N_(
        "{errors}: {factor:x.2} × the standard deviation from earlier residuals = {values}"
    ),
}


@dataclass(frozen=True)
class SigmaValues:
    """Standard deviations of one group of errors, before and in the adjustment.

    ``source`` is the source of ``used``, ``source_before`` that of ``before``; ``factor`` is their
    ratio. The LiDAR has one value for all axes, three along x, y, z, or those of range and beam
    direction. The values are None if the accuracy file contains them for each time.
    """

    group: SigmaGroup
    source: SigmaSource
    source_before: SigmaSource
    factor: float
    units: tuple[str, ...]
    before: tuple[float, ...] | None
    used: tuple[float, ...] | None


def sigmas_used(project: Project) -> tuple[SigmaValues, ...]:
    """Standard deviations of the result, or of the settings if there is no result yet."""
    return tuple(_sigmas_of_group(project, group) for group in SIGMA_GROUPS)


def _sigmas_of_group(project: Project, group: SigmaGroup) -> SigmaValues:
    settings, result = project.settings, project.result
    factor = 1.0 if result is None else result.sigma_factors[SIGMA_GROUPS.index(group)]
    before: tuple[float, ...] | None
    if group == "LiDAR":
        before = (
            settings.lidar_beam_sigma or settings.lidar_sigma_xyz or (settings.used_lidar_sigma,)
        )
        units = ("m", "deg") if settings.lidar_beam_sigma else ("m",) * len(before)
    elif group == "POS position":
        before, units = settings.used_position_sigma, ("m",) * 3
    else:
        before, units = settings.used_attitude_sigma_deg, ("deg",) * 3
    source: SigmaSource = "assumed" if group in project.assumed_sigmas else "given"
    if group == "LiDAR" and settings.is_lidar_noise_from_residuals:
        source = "estimated"
    elif project.accuracy is not None and group != "LiDAR":
        before, source = None, "file"
    return SigmaValues(
        group, source if factor == 1.0 else "estimated", source, factor, units, before,
        None if before is None else tuple(factor * value for value in before),
    )  # fmt: skip


def sigma_text(sigmas: SigmaValues, sightings: Sequence[SightingValues] = ()) -> str:
    """Values and source of standard deviations in the language in use.

    Parameters
    ----------
    sightings : sightings with POS errors, for the range of the values of an accuracy file
    """
    if sigmas.before is None or sigmas.used is None:
        errors = [each.pos_error for each in sightings if each.pos_error is not None]
        factor = fixed_number(sigmas.factor, 2)
        is_scaled = sigmas.source != "file"
        if errors:
            template = _SCALED_FILE_RANGES_TEXT if is_scaled else _FILE_RANGES_TEXT
            return gettext(template, values=_ranges_text(sigmas.group, errors), factor=factor)
        return gettext(_SCALED_FILE_TEXT if is_scaled else _FILE_TEXT, factor=factor)
    used = _values_text(sigmas, sigmas.used)
    if sigmas.factor == 1.0:
        return gettext(_SOURCE_TEXTS[sigmas.source], values=used)
    before = _values_text(sigmas, sigmas.before)
    return gettext(_ESTIMATED_TEXTS[sigmas.source_before], values=used, before=before)


def component_text(component: VarianceComponentValues, sigmas: SigmaValues) -> str:
    """Text of a variance component: factor, estimated value, interval and finding.

    Parameters
    ----------
    sigmas : standard deviations of the same group of errors
    """
    values = ""
    if sigmas.before is not None:
        estimated = tuple(component.factor * value for value in sigmas.before)
        values = _values_text(sigmas, (component.applied and sigmas.used) or estimated)
    return gettext(
        "{estimate} (95 %: {interval}), {finding}",
        estimate=gettext(
            _COMPONENT_TEXTS[sigmas.source_before], errors=gettext(COMPONENT_TITLES[sigmas.group]),
            factor=component.factor, values=values,
        ),
        interval=interval_text(component), finding=message_text(component.text),
    )  # fmt: skip


def _values_text(sigmas: SigmaValues, values: tuple[float, ...]) -> str:
    if sigmas.group == "POS position":
        return gettext("{values} m", values=triple_text(values, 3))
    if sigmas.group == "POS attitude":
        return gettext("{values}°", values=triple_text(values, 4))
    if len(values) == 1:
        return gettext("{sigma:mm.1} mm on each axis", sigma=values[0])
    if "deg" in sigmas.units:
        return gettext(
            "range {range:mm.1} mm, beam direction {angle}°",
            range=values[0], angle=fixed_number(values[1], 4),
        )  # fmt: skip
    x, y, z = values
    return gettext("x {x:mm.1} mm, y {y:mm.1} mm, z {z:mm.1} mm", x=x, y=y, z=z)


def _ranges_text(group: SigmaGroup, errors: Sequence[PosErrorValues]) -> str:
    """Smallest and largest standard deviation of each component of the POS error."""
    is_position = group == "POS position"
    decimals = 3 if is_position else 4
    ranges = []
    for values in zip(
        *(each.sigma_m if is_position else each.sigma_deg for each in errors), strict=True
    ):
        least, largest = (fixed_number(each, decimals) for each in (min(values), max(values)))
        ranges.append(
            least if least == largest else gettext("{lower} to {upper}", lower=least, upper=largest)
        )
    x, y, z = ranges
    texts = gettext("{x}, {y}, {z}", x=x, y=y, z=z)
    if is_position:
        return gettext("{values} m", values=texts)
    return gettext("{values}°", values=texts)


def sigma_facts(
    sigmas: tuple[SigmaValues, ...],
    lever_arm_sigma_m: tuple[float, ...] | None,
    sightings: Sequence[SightingValues] = (),
) -> list[Fact]:
    """Facts about the standard deviations of LiDAR, position, attitude and lever arm.

    They are in the language in use; see `sigma_text`. ``lever_arm_sigma_m`` is None if the lever
    arm is assumed exact.
    """
    of_groups = [
        Fact(gettext(SIGMA_TITLES[each.group]), sigma_text(each, sightings)) for each in sigmas
    ]
    lever_arm = _lever_arm_sigma_text(lever_arm_sigma_m)
    return [*of_groups, Fact(gettext("Lever-arm sigma (forward, left, up)"), lever_arm)]


def _lever_arm_sigma_text(sigma: tuple[float, ...] | None) -> str:
    if sigma is None:
        return gettext("not used: the given lever arm is assumed exact")
    return gettext(
        "{values} m (given; contained in the standard deviations of the angles)",
        values=triple_text(sigma, lever_arm_decimals(sigma)),
    )


def lever_arm_decimals(values: Sequence[float]) -> int:
    """Number of decimals of a given lever arm, metres: four only if it is not in millimetres."""
    is_in_millimetres = all(round(value, 3) == round(value, 4) for value in values)
    return 3 if is_in_millimetres else 4
