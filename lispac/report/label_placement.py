"""Places of the names in a plan where they cover neither marks, tracks nor each other.

The places are found when the figure is drawn, since only then the scale on the paper is known. The
search is deterministic. Lengths are points on the paper.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from lispac.report.text_width import POINTS_PER_INCH, text_width

Array = NDArray[np.float64]

DISTANCES = (3.0, 6.0, 10.0, 15.0, 21.0, 28.0, 36.0, 46.0)
"""Distances of a name from its mark, tried from the shortest to the longest."""
DIRECTIONS = 16
"""Number of directions of a name from its mark."""
LEADER_DISTANCE = 8.0
"""Distance from which a line leads from a name to its mark."""
MARK_RADIUS, TRACK_RADIUS = 4.0, 1.5
"""Half the size of a mark and of the drawn width of a track, with a small gap."""
SAMPLE_SPACING = 2.0
"""Distance of the points by which tracks and leaders are represented."""
CLEAR_DISTANCE = 4.0
"""Distance by which a name without leader is nearer to its own mark than to any other."""
SAME_MARK_DISTANCE = 0.5
"""Distance up to which two marks are one on the paper."""
PASSES = 3
"""Number of times that each name is placed; later passes know the places of all others."""
HALO_WIDTH, LEADER_HALO_WIDTH = 1.8, 1.1
"""Widths of the white edges of names and leaders."""
OVERLAP_COST, MARK_COST, OUTSIDE_COST, LEADER_COST = 400.0, 150.0, 150.0, 12.0
"""Costs of a name on another name, on a mark, across the edge of the axes, and with a leader."""
TRACK_COST, OTHER_MARK_COST, CROSSED_COST = 8.0, 100.0, 40.0
"""Costs of a name on a point of a track, of a name without leader near another mark, and of a
leader across another mark."""


@dataclass(frozen=True)
class Label:
    """A name and its mark.

    Attributes
    ----------
    place : east and north of the mark, metres
    offset : offset of the mark on the paper, points
    is_mark : whether a mark is drawn at the place; otherwise a track starts there
    """

    name: str
    place: tuple[float, float]
    colour: str
    size: float
    offset: tuple[float, float] = (0.0, 0.0)
    is_mark: bool = True


@dataclass(frozen=True)
class Track:
    """Drawn line with an arrow at its end.

    Attributes
    ----------
    points : east and north, shape (k, 2), metres
    offset, arrow : offset of the line and of the tip of its arrow on the paper, points
    """

    points: Array
    offset: tuple[float, float]
    arrow: tuple[float, float]


def draw_labels(axes: Axes, labels: Sequence[Label], tracks: Sequence[Track]) -> None:
    """Draw names beside their marks; a name that is far from its mark has a line to it."""
    if labels:
        axes.add_artist(_Labels(axes, labels, tracks))


class _Labels(Artist):
    """Annotations that are moved to free places before they are drawn."""

    def __init__(self, axes: Axes, labels: Sequence[Label], tracks: Sequence[Track]) -> None:
        super().__init__()
        self._labels, self._tracks, self._drawn_in = labels, tracks, axes
        self.set_zorder(2.9)  # before the annotations
        self.set_in_layout(False)
        self._annotations = []
        halo, leader_halo = (
            [withStroke(linewidth=width, foreground="white")]
            for width in (HALO_WIDTH, LEADER_HALO_WIDTH)
        )
        for label in labels:
            drawn = axes.annotate(
                label.name, label.place, xytext=(0, 0), textcoords="offset points", ha="center",
                va="center", fontsize=label.size, color=label.colour, zorder=3,
                arrowprops={
                    "arrowstyle": "-", "color": label.colour, "lw": 0.5, "shrinkA": 0,
                    "shrinkB": 0, "path_effects": leader_halo,
                },
                path_effects=halo,
            )  # fmt: skip
            drawn.set_in_layout(False)
            self._annotations.append(drawn)

    def draw(self, renderer: RendererBase) -> None:
        """Move the annotations to their places in the axes."""
        del renderer
        found = placed_boxes(self._drawn_in, self._labels, self._tracks)
        for label, drawn, (box, has_leader) in zip(
            self._labels, self._annotations, found, strict=True
        ):
            anchor = _on_paper(self._drawn_in, np.array([label.place]))[0]
            drawn.set_position(tuple((box[:2] + box[2:]) / 2 - anchor))
            assert drawn.arrow_patch is not None
            drawn.arrow_patch.set_visible(has_leader)


def placed_boxes(
    axes: Axes, labels: Sequence[Label], tracks: Sequence[Track]
) -> list[tuple[Array, bool]]:
    """Place of each name, and whether it has a leader.

    Returns
    -------
    list of (box, has_leader)
        box : left, lower, right and upper edge, points from the corner of the figure
    """
    anchors = np.array([
        _on_paper(axes, np.array([each.place]))[0] + each.offset for each in labels
    ])  # fmt: skip
    marks = anchors[[each.is_mark for each in labels]]
    lines = [_samples(_on_paper(axes, each.points) + each.offset) for each in tracks]
    tips = [_on_paper(axes, each.points[-1:])[0] for each in tracks]
    lines += [
        _samples(np.array([tip + each.offset, tip + each.arrow]))
        for tip, each in zip(tips, tracks, strict=True)
    ]
    drawn = np.concatenate(lines) if lines else np.zeros((0, 2))
    # The heads of the arrows are as wide as marks.
    heads = [tip + 0.6 * np.array(each.arrow) for tip, each in zip(tips, tracks, strict=True)]
    solid = np.vstack([marks, *heads]) if len(marks) + len(heads) else np.zeros((0, 2))
    inside = np.array(axes.bbox.extents) * POINTS_PER_INCH / axes.figure.dpi
    choices = [_candidates(label, anchor) for label, anchor in zip(labels, anchors, strict=True)]
    fixed = []
    for (boxes, gaps, leaders), anchor in zip(choices, anchors, strict=True):
        apart = np.hypot(*(marks - anchor).T)
        others = marks[apart > SAME_MARK_DISTANCE]
        cost = gaps + LEADER_COST * (gaps >= LEADER_DISTANCE)
        cost += MARK_COST * _touched(boxes, solid, MARK_RADIUS)
        cost += TRACK_COST * _touched(boxes, drawn, TRACK_RADIUS)
        beyond = leaders.copy()  # the part of the leaders outside the own mark
        beyond[np.hypot(*(leaders - anchor).transpose(2, 0, 1)) < MARK_RADIUS] = np.nan
        cost += CROSSED_COST * _crossed(beyond, others)
        over = np.maximum(inside[:2] - boxes[:, :2], 0) + np.maximum(boxes[:, 2:] - inside[2:], 0)
        cost += OUTSIDE_COST * (over > 0.5).any(axis=1)
        if len(others):
            nearest = np.min([_distances(boxes, each) for each in others], axis=0)
            is_ambiguous = (nearest < gaps + CLEAR_DISTANCE) & (gaps < LEADER_DISTANCE)
            cost += OTHER_MARK_COST * is_ambiguous
        fixed.append(cost)
    chosen = [int(np.argmin(cost)) for cost in fixed]
    for turn in range(PASSES):
        for k, (boxes, _, leaders) in enumerate(choices):
            cost = fixed[k].copy()
            for j in range(len(labels) if turn else k):
                if j != k:
                    box, leader = choices[j][0][chosen[j]], choices[j][2][chosen[j]]
                    cost += OVERLAP_COST * _overlap(boxes, box)
                    cost += MARK_COST * (_touched(boxes, leader, 0.5) > 0)
                    cost += MARK_COST * (
                        (leaders > box[:2] - 0.5) & (leaders < box[2:] + 0.5)
                    ).all(axis=2).any(axis=1)  # fmt: skip
            chosen[k] = int(np.argmin(cost))
    return [
        (boxes[k], bool(gaps[k] >= LEADER_DISTANCE))
        for (boxes, gaps, _), k in zip(choices, chosen, strict=True)
    ]


def _on_paper(axes: Axes, points: Array) -> Array:
    """Convert east and north (k, 2) to points on the paper."""
    pixels: Array = axes.transData.transform(points)
    return pixels * POINTS_PER_INCH / axes.figure.dpi


def _samples(points: Array) -> Array:
    """Points (m, 2) along a line with at most `SAMPLE_SPACING` between them."""
    steps = np.hypot(*np.diff(points, axis=0).T) if len(points) > 1 else np.zeros(0)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    at = np.linspace(0.0, along[-1], int(along[-1] / SAMPLE_SPACING) + 2)
    return np.column_stack([np.interp(at, along, points[:, k]) for k in (0, 1)])


def _candidates(label: Label, anchor: Array) -> tuple[Array, Array, Array]:
    """Boxes (k, 4) around a mark, their distances (k,) from it, and points (k, m, 2) of leaders.

    The points are NaN for a box without leader.
    """
    half = np.array([POINTS_PER_INCH * text_width(label.name, label.size), 1.05 * label.size]) / 2
    angles = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    towards = np.tile(np.column_stack([np.cos(angles), np.sin(angles)]), (len(DISTANCES), 1))
    gaps = np.repeat(DISTANCES, DIRECTIONS)
    # The box touches the circle with this radius around the mark.
    near = ((MARK_RADIUS if label.is_mark else 1.0) + gaps)[:, None] * towards
    centres = anchor + near + half * np.clip(2 * towards, -1, 1)
    boxes = np.hstack([centres - half, centres + half])
    shares = np.linspace(0.0, 1.0, int(max(DISTANCES) / SAMPLE_SPACING))
    leaders = anchor + shares[None, :, None] * near[:, None, :]
    leaders[gaps < LEADER_DISTANCE] = np.nan
    return boxes, gaps, leaders


def _distances(boxes: Array, point: Array) -> Array:
    """Distances of boxes (k, 4) from the edge of a mark."""
    outside = np.maximum(0, np.maximum(boxes[:, :2] - point, point - boxes[:, 2:]))
    distances: Array = np.hypot(*outside.T) - MARK_RADIUS
    return distances


def _touched(boxes: Array, points: Array, radius: float) -> Array:
    """Number of points with a radius that each box (k, 4) touches."""
    is_inside = (
        (points[None, :, :] > boxes[:, None, :2] - radius)
        & (points[None, :, :] < boxes[:, None, 2:] + radius)
    ).all(axis=2)
    return is_inside.sum(axis=1).astype(float)


def _crossed(leaders: Array, marks: Array) -> Array:
    """Number of marks (n, 2) that each leader (k, m, 2) crosses."""
    apart = np.hypot(*(leaders[:, :, None] - marks).transpose(3, 0, 1, 2))
    return (apart < MARK_RADIUS).any(axis=1).sum(axis=1).astype(float)


def _overlap(boxes: Array, box: Array) -> Array:
    """Whether each box (k, 4) overlaps another one."""
    is_apart = (boxes[:, :2] > box[2:] + 0.5) | (boxes[:, 2:] < box[:2] - 0.5)
    return (~is_apart.any(axis=1)).astype(float)
