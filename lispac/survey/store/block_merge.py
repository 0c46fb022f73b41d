"""Many sorted blocks read as one sorted line, a few of their points at a time."""

from collections.abc import Iterator

import numpy as np

from lispac.survey.store.layout import StoredColumn
from lispac.survey.store.point_blocks import Values, field_names
from lispac.survey.store.spatial_cells import Keys
from lispac.survey.store.spool import Spool

BUCKET = 1 << 20
"""Points that are in memory at once, about."""
STEP = 1024
"""Points of a block between two of its keys that the plan uses."""


def merge_blocks(spool: Spool) -> Iterator[tuple[Keys, Values]]:
    """Yield keys and values bucket by bucket, each in the order of the blocks.

    No key of a bucket is smaller than one before it. Points of one key stand in the order of their
    numbers, also across buckets, once each bucket is sorted without moving equal keys.

    Yields
    ------
    keys : ndarray of shape (n,)
    values : of n points
        Without the columns that all points of the line share.
    """
    attributes = field_names(constant_attributes(spool))
    varying = {field: column for field, column in attributes.items() if column.value is None}
    edges = _bucket_edges(spool)
    bounds = np.stack(
        [
            np.append(np.searchsorted(spool.keys(block.number), edges), block.count)
            for block in spool.blocks
        ]
    )
    for k in range(len(edges)):
        parts: list[tuple[Keys, Values]] = []
        # A key that fills buckets alone is passed on as it comes: it is in order already.
        alone = k + 1 < len(edges) and edges[k + 1] == edges[k] + np.uint64(1)
        for number, (start, stop) in enumerate(bounds[:, k : k + 2].tolist()):
            if start == stop:
                continue
            keys, values = spool.slice_of(number, start, stop)
            for field, column in field_names(spool.blocks[number].columns).items():
                if field in varying and column.value is not None:
                    values[field] = np.full(
                        (len(keys), *column.shape), column.value, dtype=column.dtype
                    )
            parts.append((keys, values))
            if alone and sum(len(keys) for keys, _ in parts) >= BUCKET:
                yield _join_parts(parts)
                parts = []
        if parts:
            yield _join_parts(parts)


def _bucket_edges(spool: Spool) -> Keys:
    """First key of each bucket, from samples of all blocks."""
    # Copied: a view would keep all keys.
    samples = [spool.keys(block.number)[::STEP].copy() for block in spool.blocks]
    edges = np.sort(np.concatenate(samples))[:: max(1, BUCKET // STEP)]
    heavy = edges[1:][edges[1:] == edges[:-1]]
    return np.unique(np.concatenate([np.zeros(1, np.uint64), edges, heavy + np.uint64(1)]))


def constant_attributes(spool: Spool) -> tuple[StoredColumn, ...]:
    """The attributes, with the value where the points of all blocks have the same one."""
    found = []
    for same in zip(*(block.columns for block in spool.blocks), strict=True):
        first = same[0]
        # By what is written of it, so that -0 and 0 differ.
        if any(str(column.value) != str(first.value) for column in same):
            first = StoredColumn(first.name, first.dtype, first.shape)
        found.append(first)
    return tuple(found)


def _join_parts(parts: list[tuple[Keys, Values]]) -> tuple[Keys, Values]:
    if len(parts) == 1:
        return parts[0]
    keys = np.concatenate([keys for keys, _ in parts])
    return keys, {f: np.concatenate([values[f] for _, values in parts]) for f in parts[0][1]}
