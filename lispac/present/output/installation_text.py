"""Sheet of a boresight and a lever arm for entering them into another program, as plain text."""

import textwrap
from collections.abc import Sequence

from lispac.language import gettext, to_plain_text
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.output.conventions import (
    ConventionValues,
    angles_table,
    angles_title,
    convention_facts,
    matrix_text,
)
from lispac.present.plain_text import TEXT_WIDTH, facts_as_text, table_as_text


def installation_text(values: ConventionValues, remarks: Sequence[Message]) -> str:
    """Convention, angles, lever arm, matrix and ``remarks``, in the language in use."""
    title = gettext("Boresight and lever arm for {program}", program=gettext(values.name))
    parts = [title, facts_as_text(gettext(values.name), convention_facts(values))]
    if values.angles:
        parts.append(table_as_text(angles_table(values, angles_title(values)), values.angles))
    if values.lever_arm_m is None:
        head = gettext("Matrix from scanner to body, without the lever arm")
    else:
        head = gettext("Matrix from scanner to body, with the lever arm in metres")
    parts.append(f"{head}\n{matrix_text(values.transform, 12)}")
    parts += [textwrap.fill(to_plain_text(message_text(each)), TEXT_WIDTH) for each in remarks]
    return "\n\n".join(parts) + "\n"
