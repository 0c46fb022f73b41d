"""Figures of the diagnostics: convergence, correlations, POS errors, weak directions."""

from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.gui.appearance import theme, units
from lispac.gui.features.estimate.adjust_parameters import MOUNTING_PARAMETERS
from lispac.gui.widgets.ticks import FONT_SIZE, SMALL_SIZE, style_axes
from lispac.language import N_, gettext
from lispac.present.angles import ANGLE_TITLES

ANGLE_MARKERS = ("o", "s", "^")
"""Markers of the angles, which can be distinguished without colours."""
DIRECTION_TITLES = (N_("weakest direction"), N_("middle direction"), N_("strongest direction"))
MIN_DRAWN_DIFFERENCE = 1e-12
"""Smallest difference drawn, in the angle unit shown; smaller ones are rounding errors."""


def draw_convergence(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the difference of each angle from its final value by iteration; 0 is the prior."""
    axes = _new_axes(figure)
    path = np.degrees(np.vstack([result.prior_boresight, result.path]))
    differences = np.abs(path - path[-1]) * units.shown_unit("°").factor
    count, last = np.arange(len(path)), np.degrees(result.angles)
    for k, title in enumerate(ANGLE_TITLES):
        value = units.local_amount(float(last[k]), "°", "+.4f")
        shown = np.where(differences[:-1, k] > MIN_DRAWN_DIFFERENCE, differences[:-1, k], np.nan)
        axes.plot(
            count[:-1],
            shown,
            color=theme.current_scheme().series[k],
            marker=ANGLE_MARKERS[k],
            markersize=4,
            linewidth=1.3,
            label=f"{gettext(title)}  {value}",
        )
    sigma = float(np.degrees(result.sigma.min()))
    sigma *= units.shown_unit("°").factor
    axes.axhline(sigma, color=theme.MUTED, linewidth=1, linestyle="--")
    axes.annotate(
        gettext("smallest σ"), (1, sigma), xycoords=("axes fraction", "data"), xytext=(-4, 3),
        textcoords="offset points", ha="right", fontsize=SMALL_SIZE, color=theme.MUTED,
    )  # fmt: skip
    axes.set_yscale("log")
    axes.set_xlabel(gettext("Iteration"), fontsize=FONT_SIZE)
    axes.set_ylabel(
        gettext("Difference from the final value, {unit}", unit=units.local_sign("°")),
        fontsize=FONT_SIZE,
    )
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.legend(fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, loc="lower left")


def draw_correlations(result: AdjustmentResult, figure: Figure) -> None:
    """Draw a heat map of the correlations of all estimated values, with numbers."""
    axes = _new_axes(figure)
    names = [short_title(name) for name in result.estimated]
    shades = LinearSegmentedColormap.from_list(
        "correlation", [theme.NEGATIVE, theme.PAPER, theme.POSITIVE]
    )
    image = axes.imshow(result.correlation_all, cmap=shades, vmin=-1, vmax=1, aspect="auto")
    for (row, column), value in np.ndenumerate(result.correlation_all):
        axes.text(
            column, row, units.localised(f"{value:+.2f}"),
            ha="center", va="center", fontsize=SMALL_SIZE,
            color=theme.TEXT,
        )  # fmt: skip
    axes.set_xticks(range(len(names)), names)
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    bar = figure.colorbar(image, ax=axes, shrink=0.9)
    bar.ax.tick_params(labelsize=SMALL_SIZE, colors=theme.TEXT)


def draw_pos_errors(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the estimated POS error of each sighting, with the band of its prior ± 2 σ."""
    figure.clear()
    parts = (
        (
            N_("Position, {unit}"), "mm", 1e3, slice(0, 3),
            (N_("north"), N_("west"), N_("up")),
        ),
        (
            N_("Attitude, {unit}"), "m°", float(np.degrees(1e3)), slice(3, 6),
            (N_("roll"), N_("pitch"), N_("heading")),
        ),
    )  # fmt: skip
    items = result.reliability
    names = [f"{item.sighting.target} {item.sighting.line}" for item in items]
    positions = np.arange(len(items))
    for subplot, (title, base, scale, which, components) in enumerate(parts, start=1):
        axes = figure.add_subplot(1, 2, subplot)
        style_axes(axes)
        scale *= units.shown_unit(base).factor
        error = np.array([item.pos_error[which] for item in items]) * scale
        prior = np.array([item.pos_sigma[which] for item in items]) * scale
        for k, component in enumerate(components):
            offset = positions + 0.24 * (k - 1)
            # One collection, since a patch for each bar would double the drawing time
            left, right, up = offset - 0.1, offset + 0.1, 2 * prior[:, k]
            corners = ((left, -up), (left, up), (right, up), (right, -up))
            bars = PolyCollection(
                np.stack([np.stack(corner, axis=-1) for corner in corners], axis=1),
                facecolor=theme.current_scheme().series[k], alpha=0.18, linewidth=0,
                label=None if k else gettext("prior ± 2 σ"),
            )  # fmt: skip
            axes.add_collection(bars)
            axes.plot(
                offset, error[:, k], linestyle="none", marker=ANGLE_MARKERS[k], markersize=4,
                color=theme.current_scheme().series[k], label=gettext(component),
            )  # fmt: skip
        axes.axhline(0, color=theme.MUTED, linewidth=0.8)
        axes.set_xticks(positions, names, rotation=60, ha="right", rotation_mode="anchor")
        for text in axes.get_xticklabels():
            text.set_parse_math(False)
            text.set_fontsize(SMALL_SIZE if len(items) < 20 else SMALL_SIZE - 2)
        axes.set_ylabel(gettext(title, unit=units.local_sign(base)), fontsize=FONT_SIZE)
        _legend_above(axes)


NAME_LETTERS = 20
"""Longest line of the name of a direction."""
LEAST_LABELLED_SHARE = 0.12
"""Smallest share of an angle whose bar is wide enough for its number."""


def draw_directions(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the shares of roll, pitch and yaw in the three eigenvectors."""
    observability = result.observability
    assert observability is not None
    axes = _new_axes(figure)
    sigma = np.degrees(observability.eigenvalues**-0.5)
    share = observability.directions**2
    left = np.zeros(3)
    for k, title in enumerate(map(gettext, ANGLE_TITLES)):
        axes.barh(range(3), share[k] * 100, left=left * 100, height=0.6,
                  color=theme.current_scheme().series[k], alpha=0.85, label=title)  # fmt: skip
        for row in range(3):
            if share[k, row] > LEAST_LABELLED_SHARE:
                text = gettext("{share:percent.0} %", share=share[k, row])
                axes.text((left[row] + share[k, row] / 2) * 100, row, text, ha="center",
                          va="center", fontsize=SMALL_SIZE, color=theme.ON_SERIES)  # fmt: skip
        left = left + share[k]
    names = [
        f"{fill(gettext(name), NAME_LETTERS)}\nσ {units.local_amount(value, '°', '.4f')}"
        for name, value in zip(DIRECTION_TITLES, sigma, strict=True)
    ]
    axes.set_yticks(range(3), names)
    axes.invert_yaxis()
    axes.set_xlim(0, 100)
    # Of the figure, since the axes are narrower than these texts
    figure.legend(
        fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, ncols=3,
        loc="outside upper center",
    )  # fmt: skip
    figure.supxlabel(
        gettext("Contribution of each angle to the direction, %"),
        fontsize=FONT_SIZE, color=theme.TEXT,
    )  # fmt: skip


def short_title(name: str) -> str:
    """Short title of an estimated value for an axis, in the user's language."""
    if name in MOUNTING_PARAMETERS:
        return gettext(MOUNTING_PARAMETERS[name].short_title)
    return gettext(ANGLE_TITLES[ANGLES.index(name)])


def _new_axes(figure: Figure) -> Axes:
    figure.clear()
    axes = figure.add_subplot()
    style_axes(axes)
    return axes


def _legend_above(axes: Axes) -> None:
    axes.legend(
        fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, ncols=4, loc="lower center",
        bbox_to_anchor=(0.5, 1.0), borderaxespad=0.1,
    )  # fmt: skip
