"""Distances between the lines on validation planes, as values and tables."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import degrees, sqrt
from operator import attrgetter
from typing import Any

from lispac.acceptance import Quantity
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.present.checking.acceptance import (
    VERDICT_TEXTS,
    AcceptanceValues,
    is_beyond_limit,
)
from lispac.present.checking.distance_bins import DistancesBySteps
from lispac.present.checking.distance_maps import DistanceMapValues
from lispac.present.tables import (
    COUNT,
    MILLIMETRES,
    PERCENT,
    PLAIN_MILLIMETRES,
    YES_NO_TEXTS,
    Column,
    Format,
    Table,
    ratio,
)
from lispac.present.text_format import grouped_number
from lispac.validation.comparison_results import (
    DistanceStatistics,
    LineShift,
    PairComparison,
    PairState,
    PlaneComparison,
    SignedStatistics,
    TwoModes,
)
from lispac.validation.plane_offset import PlaneOffset


@dataclass(frozen=True)
class DistanceValues:
    """Statistics of the unsigned distances between lines, as in `DistanceStatistics`."""

    n: int
    mean_m: float
    median_m: float
    rms_m: float
    p68_m: float
    p95_m: float
    p99_m: float
    maximum_m: float
    robust_sigma_m: float | None
    outliers: int | None

    @classmethod
    def of(cls, values: DistanceStatistics) -> "DistanceValues":
        """Values of the statistics of distances."""
        return cls(
            values.n, values.mean, values.median, values.rms, values.p68, values.p95, values.p99,
            values.maximum, values.robust_sigma, values.outliers,
        )  # fmt: skip


@dataclass(frozen=True)
class SignedDistances:
    """Distances of the first line from the second along the normal, as in `SignedStatistics`."""

    places: int
    mean_m: float
    median_m: float
    robust_sigma_m: float
    interval95_m: float
    significant_share: float
    rms_m: float | None

    @classmethod
    def of(cls, values: SignedStatistics) -> "SignedDistances":
        """Values of the statistics of signed distances."""
        return cls(
            values.n, values.mean, values.median, values.robust_sigma, values.half_width,
            values.significant, values.rms,
        )  # fmt: skip


@dataclass(frozen=True)
class PlaneOffsetValues:
    """Offset and rotation of the first line's plane from the second's, as in `PlaneOffset`."""

    offset_m: float
    offset_interval95_m: float
    rotation_horizontal_axis_deg: float
    rotation_horizontal_axis_interval95_deg: float
    rotation_slope_axis_deg: float
    rotation_slope_axis_interval95_deg: float
    angle_deg: float
    outliers: int

    @classmethod
    def of(cls, values: PlaneOffset) -> "PlaneOffsetValues":
        """Values of a plane offset, angles in degrees."""
        return cls(
            offset_m=values.offset,
            offset_interval95_m=values.offset_95,
            rotation_horizontal_axis_deg=degrees(values.rotation_horizontal_axis),
            rotation_horizontal_axis_interval95_deg=degrees(values.rotation_horizontal_axis_95),
            rotation_slope_axis_deg=degrees(values.rotation_slope_axis),
            rotation_slope_axis_interval95_deg=degrees(values.rotation_slope_axis_95),
            angle_deg=degrees(values.angle),
            outliers=values.outliers,
        )


@dataclass(frozen=True)
class PairStateValues:
    """Comparison of two lines with one boresight; None for values that could not be measured."""

    distances: DistanceValues
    signed: SignedDistances | None
    planes: PlaneOffsetValues | None

    @classmethod
    def of(cls, state: PairState) -> "PairStateValues":
        """Values of a pair with one boresight."""
        return cls(
            DistanceValues.of(state.distances),
            None if state.signed is None else SignedDistances.of(state.signed),
            None if state.planes is None else PlaneOffsetValues.of(state.planes),
        )


@dataclass(frozen=True)
class TwoModesValues:
    """Two modes of the signed distances of a pair of lines, as in `TwoModes`."""

    distance_m: float
    sigma_m: float
    share: float
    probability: float

    @classmethod
    def of(cls, modes: TwoModes) -> "TwoModesValues":
        """Values of two modes."""
        return cls(modes.distance, modes.sigma, modes.share, modes.probability)


@dataclass(frozen=True)
class LineShiftValues:
    """Mean distance of some lines from others on a plane, as in `LineShift`."""

    lines: tuple[str, ...]
    others: tuple[str, ...]
    offset_m: float
    sigma_m: float
    reciprocal: bool

    @classmethod
    def of(cls, shift: LineShift) -> "LineShiftValues":
        """Values of a shift."""
        return cls(shift.lines, shift.others, shift.offset, shift.sigma, shift.reciprocal)


@dataclass(frozen=True)
class PairValues:
    """Comparison of two lines on one validation plane."""

    line_a: str
    line_b: str
    reciprocal: bool
    before: PairStateValues
    after: PairStateValues
    modes: TwoModesValues | None = None

    @classmethod
    def of(cls, pair: PairComparison) -> "PairValues":
        """Values of the comparison of two lines."""
        return cls(
            pair.line_a,
            pair.line_b,
            pair.reciprocal,
            PairStateValues.of(pair.before),
            PairStateValues.of(pair.after),
            None if pair.modes is None else TwoModesValues.of(pair.modes),
        )

    @property
    def absolute_offset_m(self) -> float | None:
        """Absolute median signed distance after the calibration, metres."""
        return None if self.after.signed is None else abs(self.after.signed.median_m)


@dataclass(frozen=True)
class PairOffset:
    """Absolute value of the offset of two lines, as in the tables of pairs."""

    line_a: str
    line_b: str
    absolute_m: float

    @property
    def lines(self) -> str:
        """Names of the two lines."""
        return f"{self.line_a} / {self.line_b}"


@dataclass(frozen=True)
class LocalModelValues:
    """Local surface model to which distances are measured.

    Its size is given by a number of neighbours or by a radius.
    """

    kind: str
    neighbours: int | None
    radius_m: float | None


@dataclass(frozen=True)
class ValidationPlane:
    """Distances between the lines on one validation plane, with their histogram.

    The last bin includes all distances beyond it.
    """

    name: str
    pooled_from: str
    measured_to: Message
    model: LocalModelValues
    before: DistanceValues
    after: DistanceValues
    pairs: tuple[PairValues, ...]
    not_compared: tuple[tuple[str, str], ...]
    bin_edges_m: tuple[float, ...]
    counts_before: tuple[int, ...]
    counts_after: tuple[int, ...]
    by_height: DistancesBySteps | None
    by_range: DistancesBySteps | None
    maps: tuple[DistanceMapValues, ...] = ()
    shifts: tuple[LineShiftValues, ...] = ()

    @classmethod
    def of(cls, plane: PlaneComparison) -> "ValidationPlane":
        """Values of the comparison on a plane."""
        return cls(
            name=plane.name,
            pooled_from=plane.pooled_from,
            measured_to=plane.model.name,
            model=LocalModelValues(plane.model.kind, plane.model.neighbours, plane.model.radius),
            before=DistanceValues.of(plane.before),
            after=DistanceValues.of(plane.after),
            pairs=tuple(map(PairValues.of, plane.pairs)),
            not_compared=plane.not_compared,
            bin_edges_m=tuple(map(float, plane.bin_edges)),
            counts_before=tuple(map(int, plane.counts_before)),
            counts_after=tuple(map(int, plane.counts_after)),
            by_height=None if plane.by_height is None else DistancesBySteps.of(plane.by_height),
            by_range=None if plane.by_range is None else DistancesBySteps.of(plane.by_range),
            maps=tuple(map(DistanceMapValues.of, plane.maps)),
            shifts=tuple(map(LineShiftValues.of, plane.shifts)),
        )

    @property
    def largest_offset(self) -> PairOffset | None:
        """Largest offset of two lines after the calibration; None if none is known."""
        return self._largest_offset(attrgetter("after.signed"))

    @property
    def largest_offset_before(self) -> PairOffset | None:
        """Largest offset of two lines before the calibration, which may be of other lines."""
        return self._largest_offset(attrgetter("before.signed"))

    def _largest_offset(self, signed_of: Callable[[PairValues], Any]) -> PairOffset | None:
        known = [
            PairOffset(pair.line_a, pair.line_b, abs(signed.median_m))
            for pair in self.pairs
            if (signed := signed_of(pair)) is not None
        ]
        return max(known, key=attrgetter("absolute_m"), default=None)

    @property
    def largest_offset_m(self) -> float | None:
        """Largest absolute offset of two lines after the calibration, metres."""
        largest = self.largest_offset
        return None if largest is None else largest.absolute_m

    @property
    def former_offset_m(self) -> float | None:
        """Absolute offset before the calibration of the lines of `largest_offset_m`, metres."""
        largest = self.largest_offset
        offsets = None if largest is None else self.offsets_m(largest.line_a, largest.line_b)
        return None if offsets is None else abs(offsets[0])

    @property
    def largest_offset_lines(self) -> str:
        """Names of the two lines with the largest offset; empty if it is not known."""
        largest = self.largest_offset
        return "" if largest is None else largest.lines

    def offsets_m(self, line: str, other: str) -> tuple[float, float] | None:
        """Offset of two lines before and after, metres; None if it is not known."""
        for pair in self.pairs:
            before, after = pair.before.signed, pair.after.signed
            if (pair.line_a, pair.line_b) == (line, other) and before and after:
                return before.median_m, after.median_m
        return None


@dataclass(frozen=True)
class SwathDifference:
    """Root mean square of the signed distances between the lines that overlap on a plane.

    ``plane`` is empty for all planes together; ``places`` is the number of places with a distance
    after the calibration.
    """

    plane: str
    pairs: int
    places: int
    rmsd_before_m: float
    rmsd_after_m: float


def swath_overlap(planes: Sequence[PlaneComparison]) -> tuple[SwathDifference, ...]:
    """Swath overlap differences of each plane, then of all planes with signed distances."""
    per_plane = [(plane.name, _measured_pairs(plane)) for plane in planes]
    known = [(name, pairs) for name, pairs in per_plane if pairs]
    if not known:
        return ()
    every = [pair for _, pairs in known for pair in pairs]
    return tuple(_swath_difference(name, pairs) for name, pairs in (*known, ("", every)))


_BeforeAndAfter = tuple[SignedStatistics, SignedStatistics]
"""Signed distances of a pair of lines, before and after the calibration."""


def _measured_pairs(plane: PlaneComparison) -> list[_BeforeAndAfter]:
    return [
        (before, after)
        for before, after in ((pair.before.signed, pair.after.signed) for pair in plane.pairs)
        if before is not None and after is not None
        if before.rms is not None and after.rms is not None
    ]


def _swath_difference(name: str, pairs: Sequence[_BeforeAndAfter]) -> SwathDifference:
    def pooled(statistics: Sequence[SignedStatistics]) -> float:
        squares = sum(each.n * (each.rms or 0.0) ** 2 for each in statistics)
        return sqrt(squares / sum(each.n for each in statistics))

    before, after = [b for b, _ in pairs], [a for _, a in pairs]
    places = sum(each.n for each in after)
    return SwathDifference(name, len(pairs), places, pooled(before), pooled(after))


# -- tables ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class PooledDistances:
    """Table row with the statistics of the distances on a plane, before or after calibration."""

    plane: str
    state: str
    distances: DistanceValues


@dataclass(frozen=True)
class PairOnPlane:
    """Table row with a pair of lines on a validation plane."""

    plane: ValidationPlane
    pair: PairValues

    @property
    def lines(self) -> str:
        """Names of the two lines."""
        return f"{self.pair.line_a} / {self.pair.line_b}"


def pooled_rows(planes: Sequence[ValidationPlane]) -> list[PooledDistances]:
    """Rows of each plane before and after the calibration."""
    return [
        PooledDistances(plane.name, state, getattr(plane, state))
        for plane in planes
        for state in ("before", "after")
    ]


def pair_rows(planes: Sequence[ValidationPlane]) -> list[PairOnPlane]:
    """Rows of all pairs of lines on all planes."""
    return [PairOnPlane(plane, pair) for plane in planes for pair in plane.pairs]


@dataclass(frozen=True)
class ShiftOnPlane:
    """Table row with a shift of lines on a validation plane."""

    plane: str
    shift: LineShiftValues

    @property
    def w(self) -> float | None:
        """Test value: shift divided by its sigma."""
        return self.shift.offset_m / self.shift.sigma_m if self.shift.sigma_m else None


def shift_rows(planes: Sequence[ValidationPlane]) -> list[ShiftOnPlane]:
    """Rows of all shifts of lines on all planes."""
    return [ShiftOnPlane(plane.name, shift) for plane in planes for shift in plane.shifts]


ALL_PLANES_TEXT = Plural("All ({count:n} plane)", "All ({count:n} planes)")
ROTATION_FORMAT = Format("deg", 3)
STATE_TEXTS = {"before": N_("before"), "after": N_("after")}


def spread_columns(path: str) -> tuple[Column[Any], ...]:
    """Columns of the RMS and the percentiles of distances.

    Parameters
    ----------
    path : str
        Path of the field of a row that contains the `DistanceValues`.
    """
    return (
        Column(f"{path}.rms_m", N_("RMS"), PLAIN_MILLIMETRES),
        Column(f"{path}.p68_m", N_("68 %"), PLAIN_MILLIMETRES),
        Column(f"{path}.p95_m", N_("95 %"), PLAIN_MILLIMETRES),
        Column(f"{path}.p99_m", N_("99 %"), PLAIN_MILLIMETRES),
    )


POOLED_DISTANCES_TABLE = Table[PooledDistances](
    N_("Distances between lines on each plane (mm)"),
    (
        Column("plane", N_("Plane")),
        Column("state", N_("State"), texts=STATE_TEXTS),
        Column("distances.n", N_("Compared\npoints"), COUNT),
        Column("distances.mean_m", N_("Mean"), PLAIN_MILLIMETRES),
        Column("distances.median_m", N_("Median"), PLAIN_MILLIMETRES),
        *spread_columns("distances"),
        Column("distances.robust_sigma_m", N_("Robust\nsigma"), PLAIN_MILLIMETRES),
        Column("distances.outliers", N_("Outliers"), COUNT),
    ),
)


def distance_columns(before: str, after: str) -> tuple[Column[Any], ...]:
    """Columns of points, median, RMS and 95th percentile of distances before and after.

    Parameters
    ----------
    before, after : str
        Paths of the fields of a row that contain the `DistanceValues`.
    """
    return (
        Column(f"{before}.n", N_("Compared\npoints"), COUNT),
        Column(f"{before}.median_m", N_("Median\nbefore"), PLAIN_MILLIMETRES),
        Column(f"{after}.median_m", N_("Median\nafter"), PLAIN_MILLIMETRES),
        Column(f"{before}.rms_m", N_("RMS\nbefore"), PLAIN_MILLIMETRES),
        Column(f"{after}.rms_m", N_("RMS\nafter"), PLAIN_MILLIMETRES),
        Column(f"{before}.p95_m", N_("95 %\nbefore"), PLAIN_MILLIMETRES),
        Column(f"{after}.p95_m", N_("95 %\nafter"), PLAIN_MILLIMETRES),
    )


def pooled_pairs_text(plane: ValidationPlane) -> str:
    """Number of the pairs of lines in the statistics of a plane."""
    total = len(plane.pairs)
    if plane.pooled_from == "all pairs":
        return grouped_number(total)
    reciprocal = sum(pair.reciprocal for pair in plane.pairs)
    return gettext("reciprocal: {count:n} of {total:n}", count=reciprocal, total=total)


PLANE_DISTANCES_TABLE = Table[ValidationPlane](
    N_("Validation: distances between lines on planes not used in the adjustment (mm)"),
    (
        Column("name", N_("Plane")),
        Column(pooled_pairs_text, N_("Pairs\nof lines")),
        *distance_columns("before", "after"),
        Column("largest_offset_m", N_("Largest\noffset\nafter"), PLAIN_MILLIMETRES),
        Column("largest_offset_lines", N_("Lines of\nthis offset")),
        Column("former_offset_m", N_("Same lines\nbefore"), PLAIN_MILLIMETRES),
    ),
)
WINDOW_PLANES_TABLE = Table[ValidationPlane](
    N_("Validation planes before and after"),
    (
        Column(
            "name", N_("Plane"),
            tip=N_("Validation plane, and whether it meets the acceptance criteria"),
        ),
        Column(
            "after.rms_m", N_("RMS"), MILLIMETRES,
            N_("Root mean square distance between the lines, all pairs together, before → after"),
            before="before.rms_m",
        ),
        Column(
            "largest_offset_m", N_("Offset"), MILLIMETRES,
            N_(
                "Largest offset of two lines after the calibration: the absolute value of the "
                "median distance along the normal"
            ),
        ),
        Column(
            "after.p95_m", N_("95 %"), MILLIMETRES,
            N_("95 % of the distances between the lines are smaller, before → after"),
            before="before.p95_m",
        ),
        Column(
            pooled_pairs_text, N_("Pairs\nof lines"),
            tip=N_("Pairs of lines compared, which RMS, 95 % and histogram contain"),
        ),
    ),
)  # fmt: skip
"""Table of the window with the values that are compared with the acceptance criteria."""
RECIPROCAL_PAIRS_TEXT = N_(
    "{planes:names}: values of the reciprocal pairs only (lines run in opposite directions), from "
    "an earlier version of the program."
)
"""Note below tables of planes whose comparison does not use all pairs of lines."""


JUDGED_COLUMNS: Mapping[Any, Quantity] = {
    "after.rms_m": "rms", "after.p95_m": "p95", "largest_offset_m": "offset",
}  # fmt: skip
"""Columns with the values that are compared with the acceptance criteria."""


def judged_distances_table(acceptance: AcceptanceValues) -> Table[ValidationPlane]:
    """`PLANE_DISTANCES_TABLE` with marks of values beyond a limit and the verdict on each plane.

    It has no verdicts if nothing is judged.
    """
    if not any(check.plane for check in acceptance.checks):
        return PLANE_DISTANCES_TABLE
    verdicts = {each.plane: each.verdict for each in acceptance.planes}

    def judged(column: Column[ValidationPlane], quantity: Quantity) -> Column[ValidationPlane]:
        return replace(
            column, is_marked=lambda plane: is_beyond_limit(acceptance, quantity, plane.name)
        )

    columns = [
        judged(each, JUDGED_COLUMNS[each.value]) if each.value in JUDGED_COLUMNS else each
        for each in PLANE_DISTANCES_TABLE.columns
    ]
    verdict = Column[ValidationPlane](
        lambda plane: verdicts.get(plane.name), N_("Verdict"), texts=VERDICT_TEXTS
    )
    return replace(PLANE_DISTANCES_TABLE, columns=(*columns, verdict))


PAIR_DISTANCES_TABLE = Table[PairOnPlane](
    N_("Distances for every pair of lines (mm)"),
    (
        Column("plane.name", N_("Plane")),
        Column("lines", N_("Lines")),
        Column("pair.reciprocal", N_("Reciprocal"), texts=YES_NO_TEXTS),
        *distance_columns("pair.before.distances", "pair.after.distances"),
    ),
)
PAIR_PLACES_TABLE = Table[PairOnPlane](
    N_("Signed distances along the normal (mm)"),
    (
        Column("plane.name", N_("Plane")),
        Column("lines", N_("Lines")),
        Column("pair.after.signed.places", N_("Compared\nplaces"), COUNT),
        Column("pair.before.signed.median_m", N_("Offset\nbefore"), PLAIN_MILLIMETRES.signed),
        Column(
            "pair.before.signed.interval95_m", N_("95 % interval\nof a place\nbefore"),
            PLAIN_MILLIMETRES.half_interval,
        ),
        Column(
            "pair.before.signed.significant_share", N_("Significant\nplaces\nbefore"), PERCENT,
            has_unit_in_cells=True,
        ),
        Column("pair.after.signed.median_m", N_("Offset\nafter"), PLAIN_MILLIMETRES.signed),
        Column(
            "pair.after.signed.interval95_m", N_("95 % interval\nof a place\nafter"),
            PLAIN_MILLIMETRES.half_interval,
        ),
        Column(
            "pair.after.signed.significant_share", N_("Significant\nplaces\nafter"), PERCENT,
            has_unit_in_cells=True,
        ),
    ),
)  # fmt: skip
PAIR_PLANES_TABLE = Table[PairOnPlane](
    N_("Comparison of the planes fitted to two lines"),
    (
        Column("plane.name", N_("Plane")),
        Column("lines", N_("Lines")),
        *(
            Column(
                f"pair.{state}.planes.{value}_{unit}", title, form.signed,
                half_interval=f"pair.{state}.planes.{value}_interval95_{unit}",
            )
            for state, titles in (
                ("before", (
                    N_("Plane offset\nbefore"), N_("Rotation about\naxis u\nbefore"),
                    N_("Rotation about\naxis v\nbefore"),
                )),
                ("after", (
                    N_("Plane offset\nafter"), N_("Rotation about\naxis u\nafter"),
                    N_("Rotation about\naxis v\nafter"),
                )),
            )
            for (value, unit, form), title in zip(
                (
                    ("offset", "m", MILLIMETRES),
                    ("rotation_horizontal_axis", "deg", ROTATION_FORMAT),
                    ("rotation_slope_axis", "deg", ROTATION_FORMAT),
                ),
                titles, strict=True,
            )
        ),
    ),
)  # fmt: skip


SHIFTS_TABLE = Table[ShiftOnPlane](
    N_("Shifts of lines after the calibration (mm)"),
    (
        Column("plane", N_("Plane")),
        Column(lambda row: ", ".join(row.shift.lines), N_("Lines")),
        Column(lambda row: ", ".join(row.shift.others), N_("Other lines")),
        Column("shift.offset_m", N_("Shift"), PLAIN_MILLIMETRES.signed),
        Column("shift.sigma_m", N_("Sigma"), PLAIN_MILLIMETRES),
        Column("w", N_("Test value w"), ratio(1).signed),
    ),
)


def _lines_text(pair: PairValues) -> str:
    return f"{pair.line_a}{' ⇄ ' if pair.reciprocal else ' / '}{pair.line_b}"


WINDOW_PAIRS_TABLE = Table[PairValues](
    N_("Pairs of lines before and after"),
    (
        Column(
            _lines_text, N_("Lines\n(⇄ reciprocal)"),
            tip=N_(
                "The two lines. ⇄: reciprocal, run in opposite directions, where an error of the "
                "boresight is largest. /: other pair"
            ),
        ),
        Column(
            "before.distances.rms_m", N_("RMS\nbefore"), MILLIMETRES,
            N_(
                "RMS of the distances of the points of each line from the surface of the other "
                "before the calibration; it may be smaller than the offset if the lines are "
                "farther apart than their points"
            ),
        ),
        Column(
            "after.distances.rms_m", N_("RMS\nafter"), MILLIMETRES,
            N_(
                "RMS of the distances of the points of each line from the surface of the other "
                "after the calibration; it contains the noise of the points"
            ),
        ),
        Column(
            "before.signed.median_m", N_("Offset\nbefore"), MILLIMETRES.signed,
            N_(
                "Median distance of the first line from the second along the normal (M3C2) before "
                "the calibration, positive if the first is nearer to the vessel"
            ),
        ),
        Column(
            "after.signed.median_m", N_("Offset\nafter"), MILLIMETRES.signed,
            N_(
                "Median distance of the first line from the second along the normal (M3C2) after "
                "the calibration, positive if the first is nearer to the vessel"
            ),
        ),
        Column(
            "after.distances.n", N_("Points"), COUNT,
            N_(
                "Number of distances from the first line to the second and from the second to the "
                "first"
            ),
        ),
        Column(
            "before.planes.offset_m", N_("Plane offset\nbefore"), MILLIMETRES.signed,
            N_(
                "Distance between the planes fitted to the first and the second line before the "
                "calibration; positive if the first is nearer to the vessel"
            ),
        ),
        Column(
            "after.planes.offset_m", N_("Plane offset\nafter"), MILLIMETRES.signed,
            N_(
                "Distance between the planes fitted to the first and the second line after the "
                "calibration; positive if the first is nearer to the vessel"
            ),
        ),
        Column(
            "before.planes.angle_deg", N_("Tilt\nbefore"), ROTATION_FORMAT,
            N_("Angle between the planes fitted to the two lines before the calibration"),
        ),
        Column(
            "after.planes.angle_deg", N_("Tilt\nafter"), ROTATION_FORMAT,
            N_("Angle between the planes fitted to the two lines after the calibration"),
        ),
    ),
)  # fmt: skip
"""Table of the window with all pairs of lines on a plane; the report has the tables above."""


def swath_overlap_table(planes: int) -> Table[SwathDifference]:
    """Table of the swath overlap differences.

    Parameters
    ----------
    planes : int
        Number of planes, for the row of all planes.
    """
    return Table(
        N_("Swath overlap difference (RMSDn, along the normal of the surface)"),
        (
            Column(lambda row: row.plane or gettext(ALL_PLANES_TEXT, count=planes), N_("Plane")),
            Column("pairs", N_("Pairs of\nlines"), COUNT),
            Column("places", N_("Compared\nplaces"), COUNT),
            Column("rmsd_before_m", N_("RMSDn before\n(mm)"), PLAIN_MILLIMETRES),
            Column("rmsd_after_m", N_("RMSDn after\n(mm)"), PLAIN_MILLIMETRES),
        ),
    )
