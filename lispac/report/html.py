"""The report as one self-contained HTML file."""

from base64 import b64encode
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

from lispac.language import LazyText, degree_signs
from lispac.report.document import report_document
from lispac.report.document_blocks import Picture
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.report.report_values import ReportContent

_MEDIA_TYPES = {".png": "image/png", ".svg": "image/svg+xml"}
"""Media type of a picture by the suffix of its file."""


def html_text(
    content: ReportContent,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
) -> str:
    """Report as HTML, with escaped texts and embedded pictures."""
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["data_uri"] = _data_uri
    template = files("lispac.report") / "templates" / "report.html.j2"
    page = environment.from_string(template.read_text(encoding="utf-8"))
    with degree_signs():
        document = report_document(content, pictures, options)
    return page.render(document=document) + "\n"


def write_html(
    content: ReportContent,
    path: Path,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
) -> None:
    """Write the report as one HTML file.

    Parameters
    ----------
    pictures : file of a PNG or SVG picture by its caption
    """
    path.write_text(
        html_text(content, pictures, options), encoding="utf-8", errors="replace", newline="\n"
    )


def _data_uri(picture: Picture) -> str:
    return f"data:{_MEDIA_TYPES[picture.suffix]};base64,{b64encode(picture.data).decode('ascii')}"
