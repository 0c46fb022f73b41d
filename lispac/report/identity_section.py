"""The details of the survey, and the lines for signatures."""

from lispac.identity import FIELD_LABELS, FIELD_NAMES
from lispac.language import gettext
from lispac.present.tables import Fact
from lispac.report.document_blocks import SignatureLines, Table, form_table
from lispac.report.report_values import ReportContent


def identity_form(content: ReportContent) -> Table:
    """Details of the survey, as a form."""
    return form_table(
        gettext("Details of the survey"),
        [
            Fact(gettext(FIELD_LABELS[name]), getattr(content.identity, name))
            for name in FIELD_NAMES
        ],
    )


def signature_lines(content: ReportContent) -> SignatureLines:
    """Lines for surveyor, company, place, date and signature, with the known values."""
    known = content.identity
    return SignatureLines(
        (
            gettext("Surveyor"), gettext("Company"), gettext("Place and date"),
            gettext("Signature"),
        ),
        (known.surveyor, known.company, "", ""),
    )  # fmt: skip
