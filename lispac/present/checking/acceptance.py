"""Acceptance criteria and the judgement of a calibration, as values and tables."""

from dataclasses import dataclass, fields
from typing import Literal

from lispac.acceptance import (
    LIMIT_NAMES,
    PLANE_QUANTITIES,
    Acceptance,
    AcceptanceCheck,
    AcceptanceCriteria,
    Quantity,
    Verdict,
)
from lispac.language import N_, LazyText, Plural, gettext, gettext_lazy
from lispac.present.tables import Column, Format, Table, cell_text

ANGLE_FORMAT, LENGTH_FORMAT = Format("deg", 4), Format("mm", 1, 1e3)
VERDICT_TEXTS: dict[Verdict, str] = {
    "pass": N_("pass"), "fail": N_("fail"), "not judged": N_("not judged"),
}  # fmt: skip
QUANTITY_TITLES: dict[Quantity, str] = {
    "roll": N_("Standard deviation of roll"),
    "pitch": N_("Standard deviation of pitch"),
    "yaw": N_("Standard deviation of yaw"),
    "rms": N_("RMS after the calibration"),
    "p95": N_("95 % of the distances after the calibration"),
    "offset": N_("Largest offset of two lines"),
}
"""Names of the judged values."""


@dataclass(frozen=True)
class AcceptanceCriteriaValues:
    """Largest accepted values; None if a value is not judged."""

    roll_sigma_deg: float | None
    pitch_sigma_deg: float | None
    yaw_sigma_deg: float | None
    rms_m: float | None
    p95_m: float | None
    offset_m: float | None
    source: str

    @classmethod
    def of(cls, criteria: AcceptanceCriteria) -> "AcceptanceCriteriaValues":
        """Values of the criteria."""
        return cls(
            criteria.roll_sigma_deg, criteria.pitch_sigma_deg, criteria.yaw_sigma_deg, criteria.rms,
            criteria.p95, criteria.offset, criteria.source,
        )  # fmt: skip

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of the criteria that are not given, without their units."""
        limits = [field.name for field in fields(self) if field.name != "source"]
        names = [name for name in limits if getattr(self, name) is None]
        return tuple(name.removesuffix("_deg").removesuffix("_m") for name in names)


@dataclass(frozen=True)
class AcceptanceCheckValues:
    """A value and its limit in ``unit``, as in `AcceptanceCheck`."""

    quantity: Quantity
    plane: str
    lines: tuple[str, ...]
    unit: Literal["deg", "m"]
    value: float | None
    limit: float
    verdict: Verdict

    @classmethod
    def of(cls, check: AcceptanceCheck) -> "AcceptanceCheckValues":
        """Values of a check."""
        unit: Literal["deg", "m"] = "m" if check.quantity in PLANE_QUANTITIES else "deg"
        return cls(
            check.quantity, check.plane, check.lines, unit, check.value, check.limit, check.verdict
        )

    @property
    def title(self) -> str:
        """Name of the value, in the language in use."""
        return gettext(QUANTITY_TITLES[self.quantity])

    @property
    def place(self) -> str:
        """Validation plane and lines of the value; empty for an angle."""
        if not self.lines:
            return self.plane
        return gettext("{plane}: {pairs}", plane=self.plane, pairs=" / ".join(self.lines))


@dataclass(frozen=True)
class PlaneVerdict:
    """Verdict on one validation plane."""

    plane: str
    verdict: Verdict


@dataclass(frozen=True)
class AcceptanceValues:
    """Judgement of a calibration by its acceptance criteria."""

    criteria: AcceptanceCriteriaValues
    verdict: Verdict
    planes: tuple[PlaneVerdict, ...]
    excluded_planes: tuple[str, ...]
    checks: tuple[AcceptanceCheckValues, ...]

    @classmethod
    def of(cls, judgement: Acceptance) -> "AcceptanceValues":
        """Values of a judgement."""
        return cls(
            AcceptanceCriteriaValues.of(judgement.criteria),
            judgement.verdict,
            tuple(PlaneVerdict(name, judgement.verdict_on(name)) for name in judgement.planes),
            judgement.excluded,
            tuple(map(AcceptanceCheckValues.of, judgement.checks)),
        )


@dataclass(frozen=True)
class CriterionResult:
    """Judgement of one criterion, with the largest value, in ``unit``.

    Attributes
    ----------
    value : None if no value is known
    place : validation plane and lines of the value; empty for an angle
    planes : tuple of str
        Validation planes on which the criterion is not met; if it is met, that with the largest
        value; empty for an angle.
    planes_met, planes_judged : numbers of validation planes; None for an angle
    """

    quantity: Quantity
    unit: Literal["deg", "m"]
    value: float | None
    limit: float
    verdict: Verdict
    planes: tuple[str, ...]
    place: str = ""
    planes_met: int | None = None
    planes_judged: int | None = None

    @property
    def title(self) -> str:
        """Name of the value, in the language in use."""
        return gettext(QUANTITY_TITLES[self.quantity])

    @property
    def share_text(self) -> str:
        """Number of the planes that meet the criterion, in the language in use."""
        if self.planes_judged is None:
            return ""
        return gettext("{count:n} of {total:n}", count=self.planes_met, total=self.planes_judged)


def criterion_results(
    values: AcceptanceValues, verdict: Verdict | None = None
) -> list[CriterionResult]:
    """Judgement of each criterion that is given.

    Parameters
    ----------
    verdict : verdict of the wanted criteria; None for all
    """
    found: dict[Quantity, list[AcceptanceCheckValues]] = {}
    for check in values.checks:
        found.setdefault(check.quantity, []).append(check)
    results = map(_criterion_result, found.values())
    return [each for each in results if verdict in (None, each.verdict)]


def _criterion_result(checks: list[AcceptanceCheckValues]) -> CriterionResult:
    order: list[Verdict] = ["fail", "not judged", "pass"]
    worst = min(checks, key=lambda each: (order.index(each.verdict), -(each.value or 0.0)))
    decisive = [each for each in checks if each.verdict == "fail"] or [worst]
    planes = dict.fromkeys(each.plane for each in checks if each.plane)
    met = planes.keys() - {each.plane for each in checks if each.verdict != "pass"}
    return CriterionResult(
        worst.quantity, worst.unit, worst.value, worst.limit, worst.verdict,
        tuple(name for name in planes if name in {each.plane for each in decisive}), worst.place,
        len(met) if planes else None, len(planes) if planes else None,
    )  # fmt: skip


def check_format(check: AcceptanceCheckValues | CriterionResult) -> Format:
    """Format that writes a value beyond its limit differently from the limit."""
    usual = ANGLE_FORMAT if check.unit == "deg" else LENGTH_FORMAT
    return usual.apart(check.limit, check.value)


MEASURED_COLUMN, LIMIT_COLUMN = (
    Column[AcceptanceCheckValues](name, title, check_format, has_unit_in_cells=True)
    for name, title in (("value", N_("Measured")), ("limit", N_("Limit")))
)


def acceptance_table(source: str) -> Table[AcceptanceCheckValues]:
    """Table of checks.

    Parameters
    ----------
    source : document that gives the criteria; empty if unknown
    """
    return Table(
        _table_title(source),
        (
            Column("title", N_("Criterion")),
            Column("place", N_("Plane, lines")),
            MEASURED_COLUMN,
            LIMIT_COLUMN,
            Column("verdict", N_("Verdict"), texts=VERDICT_TEXTS),
        ),
    )


def criteria_table(source: str) -> Table[CriterionResult]:
    """Table of the criteria, one row each.

    Parameters
    ----------
    source : document that gives the criteria; empty if unknown
    """
    return Table(
        _table_title(source),
        (
            Column("title", N_("Criterion")),
            Column("limit", N_("Limit"), check_format, has_unit_in_cells=True),
            Column("value", N_("Largest\nvalue"), check_format, has_unit_in_cells=True),
            Column("place", N_("Plane, lines")),
            Column("share_text", N_("Planes that\nmeet it")),
            Column("verdict", N_("Verdict"), texts=VERDICT_TEXTS),
        ),
    )


def _table_title(source: str) -> str | LazyText:
    if not source:
        return N_("Acceptance criteria")
    return gettext_lazy("Acceptance criteria ({source})", source=source)


def is_beyond_limit(values: AcceptanceValues, quantity: Quantity, plane: str) -> bool:
    """Whether a value of a validation plane does not meet its criterion."""
    return any(
        (check.quantity, check.plane, check.verdict) == (quantity, plane, "fail")
        for check in values.checks
    )


def failed_texts(values: AcceptanceValues, plane: str) -> list[str]:
    """Value and limit of each criterion that a validation plane does not meet."""
    return [
        gettext(
            "{criterion}, {place}: {value}, limit {limit}",
            criterion=check.title, place=check.place, value=cell_text(MEASURED_COLUMN, check),
            limit=cell_text(LIMIT_COLUMN, check),
        )
        for check in values.checks
        if check.plane == plane and check.verdict == "fail"
    ]  # fmt: skip


def verdict_text(verdict: Verdict) -> str:
    """Verdict on a part of the calibration, in the language in use."""
    return gettext(VERDICT_TEXTS[verdict])


def calibration_verdict_text(values: AcceptanceValues) -> str:
    """Verdict on the calibration, with what it does not include."""
    verdict, scope = verdict_text(values.verdict), verdict_scope_text(values)
    if values.checks and scope:
        return gettext("{verdict} ({given})", verdict=verdict, given=scope)
    return verdict


def verdict_scope_text(values: AcceptanceValues) -> str:
    """Number of the given criteria and of the excluded planes; empty if nothing is missing."""
    total = len(LIMIT_NAMES)
    given, excluded = total - len(values.criteria.missing), len(values.excluded_planes)
    texts = []
    if given < total:
        criteria = Plural(
            "{count:n} of {total:n} criteria given", "{count:n} of {total:n} criteria given"
        )
        texts.append(gettext(criteria, count=given, total=total))
    if excluded:
        text = Plural("{count:n} validation plane excluded", "{count:n} validation planes excluded")
        texts.append(gettext(text, count=excluded))
    return ", ".join(texts)
