"""The details of the survey, and the lines for signatures."""

from lispac.identity import LABELS, NAMES
from lispac.language import gettext
from lispac.report.blocks import Signature, Table, form
from lispac.report.values import ReportContent


def identity(content: ReportContent) -> Table:
    """Details of the survey, as a form."""
    return form(
        gettext("Details of the survey"),
        [(gettext(LABELS[name]), getattr(content.identity, name)) for name in NAMES],
    )


def signature(content: ReportContent) -> Signature:
    """Lines for the signature of the surveyor."""
    known = content.identity
    return Signature(
        (
            gettext("Surveyor"), gettext("Company"), gettext("Place and date"),
            gettext("Signature"),
        ),
        (known.surveyor, known.company, "", ""),
    )  # fmt: skip
