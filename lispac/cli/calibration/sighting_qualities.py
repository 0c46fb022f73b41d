"""Quality of sightings, as text and as plain values."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from lispac.message_texts import english_text, message_text
from lispac.targets.sighting_quality import SightingQuality

Key = tuple[str, str]


def quality_values(quality: SightingQuality) -> dict[str, Any]:
    """Quality of a sighting as plain values, in degrees and metres."""
    incidence, extent = quality.incidence, quality.extent
    return {
        "rating": quality.rating,
        "reasons": list(map(english_text, quality.reasons)),
        "points": quality.points,
        "rms_m": quality.rms,
        "boresight_error_rms_m": quality.smear,
        "range_m": quality.range,
        "density_per_m2": quality.density,
        "incidence_deg": None if incidence is None else float(np.degrees(incidence)),
        "extent_m": None if extent is None else [float(side) for side in extent],
        "coverage": quality.coverage,
        "visible_share": quality.visible_share,
        "curvature_m": quality.curvature,
        "roughness_m": quality.roughness,
    }


def quality_list(qualities: Mapping[Key, SightingQuality]) -> list[dict[str, Any]]:
    """All qualities as plain values."""
    return [
        {"target": target, "line": line, **quality_values(quality)}
        for (target, line), quality in qualities.items()
    ]


def print_weak_sightings(qualities: Mapping[Key, SightingQuality]) -> None:
    """Print the sightings that are not good, the poor ones first."""
    listed = [(key, quality) for key, quality in qualities.items() if quality.rating != "good"]
    if not listed:
        return
    print("\nSightings of doubtful or poor quality:")
    for (target, line), quality in sorted(listed, key=lambda each: each[1].rating != "poor"):
        reasons = map(message_text, quality.reasons)
        print(f"- {target} on {line}: {' '.join((f'{quality.rating.capitalize()}.', *reasons))}")
