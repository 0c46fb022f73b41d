"""The report as PDF, typeset by typst.

Typst is installed as one wheel that includes its fonts. It needs no browser, no TeX and no network,
and produces the same bytes on every machine, unless a text has characters that require a system
font.
"""

import json
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from datetime import datetime
from importlib.resources import files
from pathlib import Path
from typing import Any

from lispac.errors import LispacError
from lispac.language import LazyText, degree_signs
from lispac.messages import error
from lispac.report.document import report_document
from lispac.report.document_blocks import Document
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.report.report_values import ReportContent

SECTION_GAPS, MIN_FILLED_SHARE = (1.0, 0.85, 0.7, 0.55), 0.5
"""Factors of the gaps in the sections, the first of which gives a last page that is filled to this
share of its height."""
MAX_SHORT_PAGES = 4
"""Largest number of pages of a short report, for which the gaps are reduced."""
MAX_UNBROKEN_LETTERS = 24
"""Largest number of letters of a word without break points. Longer words, such as file names, get
break points."""


def write_pdf(
    content: ReportContent,
    path: Path,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
) -> None:
    """Write the report as PDF.

    Parameters
    ----------
    pictures : file of a PNG or SVG picture by its caption

    Raises
    ------
    LispacError
        If a picture cannot be read or drawn.
    """
    with _typesetter(content, pictures, options) as set_as:
        path.write_bytes(set_as("pdf"))


@dataclass(frozen=True)
class Preview:
    """Preview of a report before it is saved: its pages as PNG pictures, and its PDF."""

    pages: tuple[bytes, ...]
    pdf: bytes


def preview_of(
    content: ReportContent,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
    *,
    ppi: float,
) -> Preview:
    """Typeset a report once, for the screen and as PDF.

    Parameters
    ----------
    pictures : file of a PNG or SVG picture by its caption
    ppi : pixels per inch of the pages

    Raises
    ------
    LispacError
        If a picture cannot be read or drawn.
    """
    with _typesetter(content, pictures, options) as set_as:
        pages = set_as("png", ppi)
        return Preview((pages,) if isinstance(pages, bytes) else tuple(pages), set_as("pdf"))


@contextmanager
def _typesetter(
    content: ReportContent, pictures: Mapping[str | LazyText, Path], options: ReportOptions
) -> Iterator[Callable[..., Any]]:
    """Context with a function that typesets the report as ``pdf``, or as ``png`` with a resolution.

    Raises
    ------
    LispacError
        If typst cannot typeset the report.
    """
    import typst

    with degree_signs():
        document = report_document(content, pictures, options)
    with tempfile.TemporaryDirectory(prefix="lispac-report-") as temporary:
        folder = Path(temporary)
        text = _write_template_input(document, folder)
        template = files("lispac.report") / "templates" / "report.typ"
        main = folder / "report.typ"
        main.write_bytes(template.read_bytes())
        # System fonts are allowed only if the text has characters that matplotlib's font lacks;
        # otherwise the PDF is the same on every machine.
        own_fonts_only = _has_fonts_for(text)

        def compiler_with(gap: float) -> typst.Compiler:
            return typst.Compiler(
                main, root=folder, font_paths=[_matplotlib_fonts()],
                ignore_system_fonts=own_fonts_only, sys_inputs={"gap": str(gap)},
            )  # fmt: skip

        made = datetime.fromisoformat(content.generated)
        try:
            compiler = _compiler_filling_last_page(
                compiler_with, MAX_SHORT_PAGES if options.extent == "short" else sys.maxsize
            )
            yield lambda kind, ppi=None: compiler.compile(format=kind, ppi=ppi, timestamp=made)
        except typst.TypstError as failure:
            given = [options.logo, *pictures.values()]
            _require_readable_pictures([path for path in given if path is not None], folder)
            raise LispacError(error("report.not_typeset", reason=str(failure.message))) from failure


def _compiler_filling_last_page(compiler_with: Callable[[float], Any], max_pages: int) -> Any:
    """Compiler with the largest gaps with which the last page is at least half full, if any.

    Gaps with which the report has at most ``max_pages`` come before all others.
    """
    best, rank = None, (2, 2)
    for gap in SECTION_GAPS:
        compiler = compiler_with(gap)
        try:
            pages, share = json.loads(compiler.query("<extent>", field="value", one=True))
        except RuntimeError:
            return compiler  # compiling gives the reason
        found = (int(pages > max_pages), int(share < MIN_FILLED_SHARE))
        if found < rank:
            best, rank = compiler, found
        if rank == (0, 0):
            break
    return best


def _require_readable_pictures(pictures: Iterable[Path], folder: Path) -> None:
    """Raise an error with the name of the first picture that typst cannot draw.

    Raises
    ------
    LispacError
        If typst cannot draw a picture.
    """
    import typst

    for path in pictures:
        name = f"alone{path.suffix.lower()}"
        (folder / name).write_bytes(path.read_bytes())
        main = folder / "alone.typ"
        main.write_text(f'#image("{name}")', encoding="utf-8")
        try:
            typst.compile(main, root=folder, format="pdf")
        except typst.TypstError as failure:
            raise LispacError(
                error("report.picture_invalid", file=str(path), reason=str(failure.message))
            ) from failure


def _write_template_input(document: Document, folder: Path) -> str:
    """Write text and pictures for the template into ``folder`` and return the text.

    The template reads the texts from JSON, and typst prints them literally, so that no part of a
    name typed by the user is interpreted as a command.
    """
    values = _with_break_points(asdict(document))
    pictures = 0
    for section in values["sections"]:
        for picture in _pictures_in(section["blocks"]):
            picture["file"] = f"picture-{pictures}{picture['suffix']}"
            (folder / picture["file"]).write_bytes(picture.pop("data"))
            pictures += 1
    if logo := values["letterhead"]["logo"]:
        logo["file"] = f"logo{logo['suffix']}"
        (folder / logo["file"]).write_bytes(logo.pop("data"))
    text = json.dumps(values, ensure_ascii=False)
    (folder / "document.json").write_text(text, encoding="utf-8", errors="replace")
    return text


def _pictures_in(blocks: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Pictures of some blocks, also those beside each other and in groups."""
    for block in blocks:
        if block["kind"] == "picture":
            yield block
        elif block["kind"] == "pictures":
            yield from _pictures_in(block["pictures"])
        elif block["kind"] == "group":
            yield from _pictures_in(block["blocks"])


def _with_break_points(value: Any, key: str = "") -> Any:
    """Values whose long words have break points inserted."""
    if isinstance(value, dict):
        # The template does not need the rows for other programs.
        return {
            name: _with_break_points(item, name)
            for name, item in value.items()
            if name != "plain_rows"
        }
    if isinstance(value, list | tuple):
        return [_with_break_points(item, key) for item in value]
    if isinstance(value, str) and any(len(word) > MAX_UNBROKEN_LETTERS for word in value.split()):
        return " ".join(_break_word(word) for word in value.split(" "))
    return value


def _break_word(word: str) -> str:
    if len(word) == 64 and word.isalnum():
        return word  # digests are not broken: their column is wide enough
    return "\u200b".join(_word_pieces(word))


def _word_pieces(word: str) -> Iterator[str]:
    """Parts of a word between its break points; long parts are split every eight characters."""
    for run in word.split("\u200b"):
        if len(run) <= MAX_UNBROKEN_LETTERS:
            yield run
        else:
            yield from (run[k : k + 8] for k in range(0, len(run), 8))


def _matplotlib_fonts() -> Path:
    import matplotlib

    return Path(matplotlib.get_data_path()) / "fonts" / "ttf"


def _has_fonts_for(text: str) -> bool:
    from lispac.report.figures import drawable_characters

    return all(ord(letter) in drawable_characters() or letter.isspace() for letter in text)
