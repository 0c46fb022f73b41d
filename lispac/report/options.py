"""Options of a report: extent, language, page, convention of another program, letterhead."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from lispac.language import N_

Page = Literal["a4", "letter"]
PAGE_SIZES: dict[Page, str] = {"a4": "A4", "letter": N_("Letter")}
"""Sizes of paper with their names."""
Extent = Literal["short", "full"]
EXTENTS: dict[Extent, str] = {
    "short": N_("Short, for signature"), "full": N_("Full report"),
}  # fmt: skip
"""Extents of a report with their names. JSON and the CSV tables are always complete."""


@dataclass(frozen=True)
class ReportOptions:
    """Options of a report.

    Attributes
    ----------
    convention : key of another program in whose convention the boresight is also given; empty for
        none
    logo : PNG or SVG file at the top of page one
    company : text beside the logo, one or more lines
    heading : text under the title
    closing : text above the signature
    language : code of one of `LANGUAGES`
    extent : result, validation, pictures and signature only, or everything
    """

    page: Page = "a4"
    convention: str = ""
    logo: Path | None = None
    company: str = ""
    heading: str = ""
    closing: str = ""
    language: str = "en"
    extent: Extent = "short"


DEFAULT_OPTIONS = ReportOptions()
