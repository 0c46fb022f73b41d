"""Sightings of doubtful or poor quality, as text."""

from collections.abc import Mapping

from lispac.language import to_plain_text
from lispac.present.sighting_quality import rating_text, sighting_quality_values
from lispac.targets.sighting_quality import SightingQuality

Key = tuple[str, str]


def print_weak_sightings(qualities: Mapping[Key, SightingQuality]) -> None:
    """Print the sightings that are not good, the poor ones first."""
    listed = [(key, quality) for key, quality in qualities.items() if quality.rating != "good"]
    if not listed:
        return
    print("\nSightings of doubtful or poor quality:")
    for (target, line), quality in sorted(listed, key=lambda each: each[1].rating != "poor"):
        text = rating_text(sighting_quality_values(target, line, quality))
        print(f"- {target} on {line}: {to_plain_text(text)}")
