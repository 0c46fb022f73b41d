"""Style and tick labels of a plot, in the unit shown and with the decimal sign of the language."""

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import Formatter, FuncFormatter, LogLocator, MaxNLocator, ScalarFormatter
from PySide6.QtCore import QLocale

from lispac.gui.appearance import theme, units
from lispac.gui.appearance.units import Base

FONT_SIZE, SMALL_SIZE = 9, 8
"""Font sizes of titles and labels, and of tick labels and legends, points."""


def convert_axis_units(axis: Axis, base: Base, spacing: float | None = None) -> None:
    """Label an axis with round values in the unit shown instead of its base unit.

    Parameters
    ----------
    spacing : smallest distance of two ticks, inches; None for that of Matplotlib
    """
    if spacing is not None:
        axis.set_major_locator(_RoundLocator(1.0, spacing))
    if not units.is_converted(base):
        return
    factor = units.shown_unit(base).factor
    is_log = isinstance(axis.get_major_locator(), LogLocator)
    axis.set_major_locator(_RoundLogLocator(factor) if is_log else _RoundLocator(factor, spacing))
    axis.set_major_formatter(
        FuncFormatter(lambda value, _: _localised_label(f"{value * factor:.6g}"))
    )
    axis.set_label_text(units.convert_unit_signs(axis.get_label_text(), base, figures=False))


def localise_ticks(figure: Figure) -> None:
    """Label all plain axes with the decimal sign of the user's language."""
    if QLocale().decimalPoint() == ".":
        return
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            plain = axis.get_major_formatter()
            if type(plain) is ScalarFormatter:
                axis.set_major_formatter(_LocalFormatter(plain))


def _localised_label(text: str) -> str:
    return text.replace(".", QLocale().decimalPoint()).replace("-", "\N{MINUS SIGN}")


class _RoundLocator(MaxNLocator):
    """Locator of ticks at round values of a unit, as far apart as their labels need.

    Parameters
    ----------
    factor : number of the unit in one base unit
    spacing : smallest distance of two ticks, inches; None for that of Matplotlib
    """

    def __init__(self, factor: float, spacing: float | None) -> None:
        super().__init__(nbins="auto", steps=[1, 2, 2.5, 5, 10])
        self._factor, self._spacing = factor, spacing

    def __call__(self) -> Sequence[float]:
        """Ticks for the present length of the axis, which its aspect may have reduced.

        Axes that share the axis have the same length, but are reduced only when they are drawn.
        """
        if self._spacing is not None and self.axis is not None:
            axes = self.axis.axes
            is_horizontal = self.axis.axis_name == "x"
            shared = axes.get_shared_x_axes() if is_horizontal else axes.get_shared_y_axes()
            boxes = [each.bbox for each in shared.get_siblings(axes)]
            pixels = min(each.width if is_horizontal else each.height for each in boxes)
            bins = int(pixels / axes.figure.dpi / self._spacing)
            self.set_params(nbins=max(bins, 1), min_n_ticks=1)
        return super().__call__()

    def tick_values(self, vmin: float, vmax: float) -> Sequence[float]:
        found = super().tick_values(vmin * self._factor, vmax * self._factor)
        return [float(each) / self._factor for each in found]


class _RoundLogLocator(LogLocator):
    """Locator of ticks at 1, 2 and 5 times powers of ten of another unit."""

    def __init__(self, factor: float) -> None:
        super().__init__(subs=(1.0, 2.0, 5.0))
        self._factor = factor

    def tick_values(self, vmin: float, vmax: float) -> Sequence[float]:
        found = super().tick_values(vmin * self._factor, vmax * self._factor)
        return [float(each) / self._factor for each in found]


class _LocalFormatter(Formatter):
    """Formatter that localises the decimal sign in the labels of another formatter."""

    def __init__(self, plain: ScalarFormatter) -> None:
        self._plain = plain

    def __call__(self, value: float, place: int | None = None) -> str:
        return _localised_label(self._plain(value, place))

    def set_axis(self, axis: Axis) -> None:
        super().set_axis(axis)
        self._plain.set_axis(axis)

    def set_locs(self, locs: Sequence[float]) -> None:
        super().set_locs(locs)
        self._plain.set_locs(locs)

    def get_offset(self) -> str:
        return _localised_label(self._plain.get_offset())


def style_axes(axes: Axes) -> None:
    """Set colours and font size of axes without a frame."""
    axes.set_facecolor(theme.PAPER)
    axes.tick_params(labelsize=SMALL_SIZE, colors=theme.TEXT)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(theme.MUTED)
    for label in (axes.xaxis.label, axes.yaxis.label):
        label.set_color(theme.TEXT)
