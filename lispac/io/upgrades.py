"""Project files of older versions, brought up to date one version after the other."""

from collections.abc import Callable
from typing import Any

from lispac.foreign_values import InvalidContentError
from lispac.messages import error

Content = dict[str, Any]

SCHEMA_VERSION = 9


def upgraded(content: Content) -> Content:
    """The content of a project file as this version writes it."""
    for version in range(content["schema_version"], SCHEMA_VERSION):
        content = _UPGRADES[version](dict(content))
    return content


def _from_1(content: Content) -> Content:
    """Version 2 knows more of an adjustment; one of version 1 has to be repeated.

    The given model is kept: a project that was set to thesis mode stays so.
    """
    targets = [target | {"shape": "plane", "sphere_radius": None} for target in content["targets"]]
    return content | {
        "schema_version": 2,
        "targets": targets,
        "result": None,
        "cross_checks": None,
        "validation": [],
        "not_compared": {},
    }


def _from_2(content: Content) -> Content:
    """Version 3 adds the reading options of each file; before, there was one way for each."""
    usual = {"format": "", "options": [], "time_shift": 0.0}
    return content | {
        "schema_version": 3,
        "trajectory_reading": usual,
        "accuracy_reading": usual,
        "lines": [line | {"reading": usual} for line in content["lines"]],
    }


def _from_3(content: Content) -> Content:
    """Version 4 adds the search settings of a target; before, there was no choice."""
    targets = [target | {"choices": None} for target in content["targets"]]
    return content | {"schema_version": 4, "targets": targets}


def _from_4(content: Content) -> Content:
    """Version 5 adds figures to a comparison of lines; they stay unknown for older versions."""

    def state(distances: Content) -> Content:
        return {"distances": distances, "signed": None, "planes": None}

    usual = {"kind": "plane", "neighbours": 6, "radius": None}
    validation = [
        plane
        | {"model": usual, "by_height": None, "by_range": None}
        | {
            "pairs": [
                pair | {when: state(pair[when]) for when in ("before", "after")}
                for pair in plane["pairs"]
            ]
        }
        for plane in content["validation"]
    ]
    return content | {"schema_version": 5, "validation": validation}


def _from_5(content: Content) -> Content:
    """Version 6 adds the details for the report; blank for older versions."""
    return content | {"schema_version": 6, "identity": {}}


def _from_6(content: Content) -> Content:
    """Version 7 adds second surfaces in a check against a reference.

    Before, the mean of both was taken, and nobody knows where. Surveyed points have an interval.
    """
    absolute = content.get("absolute")
    if absolute:
        points = [point | {"interval_95": None} for point in absolute["points"]]
        absolute = absolute | {"others": None, "points": points}
    return content | {"schema_version": 7, "absolute": absolute}


def _from_7(content: Content) -> Content:
    """Version 8 adds the results of alternative methods; none in older versions."""
    return content | {"schema_version": 8, "opinions": []}


def _from_8(content: Content) -> Content:
    """Version 9 stores reasons and remarks as messages; as text from older versions."""
    targets = [
        target | {"missing": {line: _former_text(why) for line, why in target["missing"].items()}}
        for target in content["targets"]
    ]
    not_compared = {name: _former_text(why) for name, why in content["not_compared"].items()}
    return content | {
        "schema_version": 9,
        "targets": targets,
        "not_compared": not_compared,
        "result": _result_from_8(content["result"]),
        "cross_checks": _cross_checks_from_8(content["cross_checks"]),
        "absolute": _absolute_from_8(content.get("absolute")),
        "opinions": [
            each | {"remarks": _former_texts(each["remarks"])} for each in content["opinions"]
        ],
    }


def _result_from_8(result: Any) -> Any:
    if not result:
        return result
    seen = dict(result["observability"] or {})
    if seen:
        seen["remarks"] = _former_texts(seen.pop("sentences"))
    return result | {
        "observability": seen or None,
        "parameters": [_reason_from_8(each) for each in result["parameters"]],
    }


def _cross_checks_from_8(checks: Any) -> Any:
    return checks and checks | {"parts": [_reason_from_8(each) for each in checks["parts"]]}


def _absolute_from_8(check: Any) -> Any:
    if not check:
        return check
    check = dict(check)
    return check | {"not_compared": _former_texts(check.pop("unseen"))}


def _reason_from_8(found: Content) -> Content:
    """An estimate, or a part of the data: an empty reason is none."""
    return found | {"reason": _former_text(found["reason"]) if found["reason"] else None}


def _former_texts(texts: Any) -> list[Content]:
    return [_former_text(each) for each in texts]


def _former_text(text: Any) -> Content:
    if not isinstance(text, str):
        raise InvalidContentError(error("content.value_not_text"))
    return {"code": "project.former_text", "level": "note", "params": {"reason": text}}


_UPGRADES: dict[int, Callable[[Content], Content]] = {
    1: _from_1,
    2: _from_2,
    3: _from_3,
    4: _from_4,
    5: _from_5,
    6: _from_6,
    7: _from_7,
    8: _from_8,
}
