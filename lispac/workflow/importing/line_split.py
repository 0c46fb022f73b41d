"""Splitting of a file with several scanners or survey lines into lines."""

import sys
from dataclasses import replace

from lispac.errors import InputError
from lispac.messages import error
from lispac.project import LineSource
from lispac.survey.line_audit import LineAudit
from lispac.survey.point_screening import AttributeCondition
from lispac.workflow.importing.file_audit import audit_file
from lispac.workflow.importing.file_reading import format_of_line

GAP_CRITERION = "gap"
"""Criterion that splits a line at gaps in its times."""


def split_line(line: LineSource, by: str) -> tuple[LineSource, ...]:
    """Split a file into lines: one for each value of an attribute, or between gaps in time.

    Parameters
    ----------
    line : LineSource
    by : str
        Attribute (``point_source_id``, ``scanner_channel``, ``user_data`` ...), or ``gap``.

    Returns
    -------
    tuple of LineSource
        Lines of the same file, each with the option ``only``; ``line`` itself if there is only one.

    Raises
    ------
    InputError
        If the file cannot be read, or its points do not have the attribute.
    """
    format, choice, _ = format_of_line(line)
    found = audit_file(line.path, format, choice, max_points=sys.maxsize)
    if by != GAP_CRITERION and by not in found.attributes:
        raise InputError(
            error(
                "import.no_attribute",
                file=str(line.path),
                attribute=by,
                known=sorted(found.attributes),
            )
            if found.attributes
            else error("import.no_attributes", file=str(line.path), attribute=by)
        )
    return parts_of_line(line, found.audit, by, format.key)


def parts_of_line(line: LineSource, audit: LineAudit, by: str, key: str) -> tuple[LineSource, ...]:
    """Lines into which a file is split, from its audit.

    Parameters
    ----------
    by : str
        As for `split_line`.
    key : str
        Key of the file format.
    """
    if by == GAP_CRITERION:
        conditions = [AttributeCondition("time", start, end) for start, end in audit.spans]
        names = [f"{line.name}_{k}" for k in range(1, len(conditions) + 1)]
    else:
        values = [float(value) for value in audit.groups.get(by, ())]
        conditions = [AttributeCondition(by, value, value) for value in values]
        names = [f"{line.name}_{value:g}" for value in values]
    if len(conditions) < 2:
        return (line,)
    return tuple(
        _line_with_condition(line, name, condition, key)
        for name, condition in zip(names, conditions, strict=True)
    )


def _line_with_condition(
    line: LineSource, name: str, condition: AttributeCondition, key: str
) -> LineSource:
    """Line with another name that contains only the points that meet a condition."""
    options = dict(line.reading.options)
    before = options.get("only", "")
    options["only"] = f"{before} {condition}".strip()
    if line.columns:
        options.setdefault("columns", " ".join(line.columns))
    format = line.reading.format or key
    reading = replace(line.reading, format=format, options=tuple(options.items()))
    return replace(line, name=name, columns=(), reading=reading)
