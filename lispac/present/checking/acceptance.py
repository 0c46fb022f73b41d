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
from lispac.language import N_, Plural, gettext, gettext_lazy
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
    """Largest value judged by one criterion, in ``unit``.

    Attributes
    ----------
    planes : tuple of str
        Validation planes on which the criterion is not met; if it is met, that with the largest
        value; empty for an angle.
    """

    quantity: Quantity
    unit: Literal["deg", "m"]
    value: float | None
    limit: float
    verdict: Verdict
    planes: tuple[str, ...]


def criterion_results(
    values: AcceptanceValues, verdict: Verdict | None = None
) -> list[CriterionResult]:
    """Largest value of each criterion that is given.

    Parameters
    ----------
    verdict : verdict of the wanted criteria; None for all
    """
    found: dict[Quantity, list[AcceptanceCheckValues]] = {}
    for check in decisive_checks(values):
        found.setdefault(check.quantity, []).append(check)
    names = dict.fromkeys(each.plane for each in values.checks if each.plane)
    return [
        CriterionResult(
            worst.quantity, worst.unit, worst.value, worst.limit, worst.verdict,
            tuple(name for name in names if name in {each.plane for each in checks}),
        )
        for checks in found.values()
        for worst in checks[:1]
        if verdict in (None, worst.verdict)
    ]  # fmt: skip


def decisive_checks(
    values: AcceptanceValues, max_failed: int | None = None
) -> list[AcceptanceCheckValues]:
    """The failed checks of each criterion; without one, that of the plane with the worst value.

    Parameters
    ----------
    max_failed : largest number of failed checks of each criterion, those with the largest values;
        None for all. A single one more is not omitted, since it needs no more space than the
        sentence that it is omitted.
    """
    order: list[Verdict] = ["fail", "not judged", "pass"]
    decisive: dict[Quantity, list[AcceptanceCheckValues]] = {
        check.quantity: [] for check in values.checks
    }
    for check in sorted(
        values.checks, key=lambda each: (order.index(each.verdict), -(each.value or 0.0))
    ):
        if not decisive[check.quantity] or check.verdict == "fail":
            decisive[check.quantity].append(check)
    shown = [check for checks in decisive.values() for check in checks[:max_failed]]
    every = [check for checks in decisive.values() for check in checks]
    return every if len(every) == len(shown) + 1 else shown


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
        gettext_lazy("Acceptance criteria ({source})", source=source)
        if source
        else N_("Acceptance criteria"),
        (
            Column("title", N_("Criterion")),
            Column("place", N_("Plane, lines")),
            MEASURED_COLUMN,
            LIMIT_COLUMN,
            Column("verdict", N_("Verdict"), texts=VERDICT_TEXTS),
        ),
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
