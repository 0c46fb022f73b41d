"""The quay of the resources with few choices, so that a design is found quickly."""

from collections.abc import Mapping

from lispac.installation_paths import resource_path

NARROWED = {
    "along_m = [-8, -4, -1, 1, 4, 8]": "along_m = [-1, 1]",
    "inclination_deg = [90, 60, 45, 120, 135]": "inclination_deg = [90, 45]",
    "lines = 6": "lines = 3",
    "headings_deg = [0, 45, 90, 135, 180, 225, 270, 315]": "headings_deg = [0, 45, 135]",
    "distances_m = [10, 15, 20, 30, 40]": "distances_m = [15]",
}


def narrow_site(others: Mapping[str, str]) -> str:
    """Text of the site with further replacements."""
    text = (resource_path("sites") / "quay.toml").read_text(encoding="utf-8")
    for wide, narrow in {**NARROWED, **others}.items():
        assert wide in text
        text = text.replace(wide, narrow)
    return text
