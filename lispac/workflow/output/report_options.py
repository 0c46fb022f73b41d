"""Options of a report; a template contains those that a company always uses."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from lispac.errors import InputError, system_reason
from lispac.io.files import require_file
from lispac.language import LANGUAGES
from lispac.messages import error
from lispac.report.options import DEFAULT_OPTIONS, EXTENTS, PAGE_SIZES, Extent, Page, ReportOptions
from lispac.survey.conventions.systems import convention_of_key
from lispac.untrusted_values import InvalidContentError, toml_values

TEMPLATE_KEYS = (
    "logo", "company", "heading", "closing", "page", "convention", "language", "extent",
)  # fmt: skip
"""Keys of a report template."""
MAX_TEXT_LENGTH = 2000
"""Largest number of characters of a text in a template."""


def report_options(
    template: Path | None = None,
    page: str = "",
    convention: str = "",
    language: str = "",
    extent: str = "",
) -> ReportOptions:
    """Options from a template, if there is one, overridden by the chosen options.

    Raises
    ------
    InputError
        If the template or a chosen option is not valid.
    """
    options = DEFAULT_OPTIONS if template is None else _read_template(Path(template))
    if page:
        options = replace(options, page=_parse_page(page))
    if convention:
        options = replace(options, convention=convention_of_key(convention).key)
    if language:
        options = replace(options, language=_parse_language(language))
    if extent:
        options = replace(options, extent=_parse_extent(extent))
    return options


def _read_template(path: Path) -> ReportOptions:
    require_file(path, "report template")
    try:
        content = toml_values(path.read_bytes())
    except (OSError, InvalidContentError) as failure:
        reason = (
            failure.reason if isinstance(failure, InvalidContentError) else system_reason(failure)
        )
        raise InputError(
            error("report_template.not_toml", file=str(path), reason=reason)
        ) from failure
    for key, value in content.items():
        if key not in TEMPLATE_KEYS:
            raise InputError(
                error("report_template.unknown_key", file=str(path), key=key, keys=TEMPLATE_KEYS)
            )
        if not isinstance(value, str):
            raise InputError(error("report_template.not_text", file=str(path), key=key))
    try:
        return ReportOptions(
            page=_parse_page(content.get("page", DEFAULT_OPTIONS.page)),
            convention=convention_of_key(content["convention"]).key
            if content.get("convention")
            else "",
            language=_parse_language(content.get("language", DEFAULT_OPTIONS.language)),
            extent=_parse_extent(content.get("extent", DEFAULT_OPTIONS.extent)),
            logo=_find_logo(path.parent, content["logo"]) if content.get("logo") else None,
            **{
                key: _clean_text(key, content.get(key, ""))
                for key in ("company", "heading", "closing")
            },
        )
    except InputError as failure:
        raise InputError(
            error("report_template.refused", file=str(path), reason=failure.reason)
        ) from failure


def _parse_page(text: Any) -> Page:
    for page in PAGE_SIZES:
        if text.strip().lower() == page:
            return page
    raise InputError(error("report_template.no_page", page=str(text), pages=tuple(PAGE_SIZES)))


def _parse_language(text: str) -> str:
    code = text.strip().lower()
    if code not in LANGUAGES:
        raise InputError(
            error("report_template.no_language", language=str(text), languages=tuple(LANGUAGES))
        )
    return code


def _parse_extent(text: str) -> Extent:
    for extent in EXTENTS:
        if text.strip().lower() == extent:
            return extent
    raise InputError(error("report_template.no_extent", extent=text, extents=tuple(EXTENTS)))


def _find_logo(folder: Path, name: str) -> Path:
    """Find the logo of a template, which must be in the folder of the template.

    This prevents a template from another source from including any file of the computer.

    Raises
    ------
    InputError
        If it is in another folder, or is not an image.
    """
    path = folder / name
    if not path.resolve().is_relative_to(folder.resolve()):
        raise InputError(error("report_template.logo_elsewhere", logo=name))
    require_file(path, "logo")
    suffix = path.suffix.lower()
    start = path.read_bytes()[:4096]
    if suffix == ".png" and start.startswith(b"\x89PNG\r\n\x1a\n"):
        return path
    if suffix == ".svg" and b"<svg" in start:
        return path
    raise InputError(error("report_template.logo_format", logo=str(path)))


def _clean_text(key: str, text: str) -> str:
    tidy = "\n".join(line.strip() for line in text.strip().splitlines())
    if len(tidy) > MAX_TEXT_LENGTH or any(not (c.isprintable() or c == "\n") for c in tidy):
        raise InputError(error("report_template.long_text", key=key, limit=MAX_TEXT_LENGTH))
    return tidy
