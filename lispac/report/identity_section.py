"""Who calibrated what, when and with what, and the lines it is signed on."""

from lispac.identity import LABELS, NAMES
from lispac.report.blocks import Signature, Table, form
from lispac.report.values import ReportContent


def identity(content: ReportContent) -> Table:
    """Details of the survey, as a form."""
    return form(
        "Details of the survey",
        [(LABELS[name], getattr(content.identity, name)) for name in NAMES],
    )


def signature(content: ReportContent) -> Signature:
    """Who signs."""
    known = content.identity
    return Signature(
        ("Surveyor", "Company", "Place and date", "Signature"),
        (known.surveyor, known.company, "", ""),
    )
