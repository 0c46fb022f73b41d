"""Upgrade of project files of older versions, one version after the other."""

from collections.abc import Callable
from typing import Any

from lispac.former_names import renamed_keys, renamed_reading
from lispac.messages import error
from lispac.untrusted_values import InvalidContentError

Content = dict[str, Any]

SCHEMA_VERSION = 17


def upgrade_content(content: Content) -> Content:
    """Convert the content of a project file to the present version."""
    for version in range(content["schema_version"], SCHEMA_VERSION):
        content = _UPGRADES[version](dict(content))
    return content


def _upgrade_from_1(content: Content) -> Content:
    """Upgrade to version 2, without the result, which has to be estimated again.

    The stochastic model is kept: a project with independent POS errors keeps them.
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


def _upgrade_from_2(content: Content) -> Content:
    """Upgrade to version 3, which contains the reading options of each file."""
    usual = {"format": "", "options": [], "time_shift": 0.0}
    return content | {
        "schema_version": 3,
        "trajectory_reading": usual,
        "accuracy_reading": usual,
        "lines": [line | {"reading": usual} for line in content["lines"]],
    }


def _upgrade_from_3(content: Content) -> Content:
    """Upgrade to version 4, which contains the finder options of each target."""
    targets = [target | {"choices": None} for target in content["targets"]]
    return content | {"schema_version": 4, "targets": targets}


def _upgrade_from_4(content: Content) -> Content:
    """Upgrade to version 5, which contains more details of a comparison of lines."""

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


def _upgrade_from_5(content: Content) -> Content:
    """Upgrade to version 6, which contains the identity of the calibration."""
    return content | {"schema_version": 6, "identity": {}}


def _upgrade_from_6(content: Content) -> Content:
    """Upgrade to version 7, which contains the second surfaces of a check against a reference.

    Earlier versions used the mean of both surfaces without a record of the places concerned.
    Surveyed points have an interval.
    """
    absolute = content.get("absolute")
    if absolute:
        points = [point | {"interval_95": None} for point in absolute["points"]]
        absolute = absolute | {"others": None, "points": points}
    return content | {"schema_version": 7, "absolute": absolute}


def _upgrade_from_7(content: Content) -> Content:
    """Upgrade to version 8, which contains the results of alternative methods."""
    return content | {"schema_version": 8, "opinions": []}


def _upgrade_from_8(content: Content) -> Content:
    """Upgrade to version 9, which contains reasons and notes as messages."""
    targets = [
        target | {"missing": {line: _former_text(why) for line, why in target["missing"].items()}}
        for target in content["targets"]
    ]
    not_compared = {name: _former_text(why) for name, why in content["not_compared"].items()}
    return content | {
        "schema_version": 9,
        "targets": targets,
        "not_compared": not_compared,
        "result": _upgrade_result_from_8(content["result"]),
        "cross_checks": _upgrade_checks_from_8(content["cross_checks"]),
        "absolute": _upgrade_absolute_from_8(content.get("absolute")),
        "opinions": [
            each | {"remarks": _former_texts(each["remarks"])} for each in content["opinions"]
        ],
    }


def _upgrade_result_from_8(result: Any) -> Any:
    if not result:
        return result
    observability = dict(result["observability"] or {})
    if observability:
        observability["remarks"] = _former_texts(observability.pop("sentences"))
    return result | {
        "observability": observability or None,
        "parameters": [_upgrade_reason_from_8(each) for each in result["parameters"]],
    }


def _upgrade_checks_from_8(checks: Any) -> Any:
    return checks and checks | {"parts": [_upgrade_reason_from_8(each) for each in checks["parts"]]}


def _upgrade_absolute_from_8(check: Any) -> Any:
    if not check:
        return check
    check = dict(check)
    return check | {"not_compared": _former_texts(check.pop("unseen"))}


def _upgrade_reason_from_8(content: Content) -> Content:
    """Convert the reason of an estimate, or of a part of the data: an empty text becomes None."""
    return content | {"reason": _former_text(content["reason"]) if content["reason"] else None}


def _former_texts(texts: Any) -> list[Content]:
    return [_former_text(each) for each in texts]


def _former_text(text: Any) -> Content:
    if not isinstance(text, str):
        raise InvalidContentError(error("content.value_not_text"))
    return {"code": "project.former_text", "level": "note", "params": {"reason": text}}


_PLANE_NAMES_FROM_9 = {
    "strays": "outliers",
    "turn_level": "rotation_horizontal_axis",
    "turn_level_95": "rotation_horizontal_axis_95",
    "turn_upright": "rotation_slope_axis",
    "turn_upright_95": "rotation_slope_axis_95",
}
_NAMES_FROM_9 = {
    "": {"opinions": "alternative_results"},
    "settings": {"accept_one_facing": "accept_single_orientation"},
    "result": {
        "left_out": "excluded_outliers",
        "raised": "angle_sigma_factors",
        "stated_times": "given_correlation_times",
    },
    "result.observability": {"remarks": "messages"},
    "result.reliability": {"strays": "outliers", "released": "rejected"},
    "result.contradictions": {"moved": "angle_change", "surface": "surface_sigma"},
    "result.causes": {"moved": "angle_change"},
    "cross_checks.parts": {"without": "part"},
    "validation.pairs.before.planes": _PLANE_NAMES_FROM_9,
    "validation.pairs.after.planes": _PLANE_NAMES_FROM_9,
    "absolute": {
        "reach": "search_distance",
        "together": "all_lines",
        "others": "other_surfaces",
    },
    "opinions": {"remarks": "messages"},
}
"""New field names by those of version 9, for each table of the file."""


def _upgrade_from_9(content: Content) -> Content:
    """Upgrade to version 10, whose field names use the standard terms."""
    return renamed_keys(content, _NAMES_FROM_9) | {"schema_version": 10}


def _upgrade_from_10(content: Content) -> Content:
    """Upgrade to version 11, whose reading options use the standard terms."""
    lines = [line | {"reading": renamed_reading(line["reading"])} for line in content["lines"]]
    return content | {"schema_version": 11, "lines": lines}


def _upgrade_from_11(content: Content) -> Content:
    """Upgrade to version 12, which contains acceptance criteria."""
    return content | {"schema_version": 12, "acceptance": {}}


def _upgrade_from_12(content: Content) -> Content:
    """Upgrade to version 13, whose cross-checks contain only the results of the subsets.

    Its standard deviations may be None, if nobody gave them. Those of earlier versions stay given,
    because these versions did not record who gave them.
    """
    checks = content["cross_checks"]
    if checks is not None:
        checks = {"parts": checks["parts"]}
    return content | {"schema_version": 13, "cross_checks": checks}


def _upgrade_from_13(content: Content) -> Content:
    """Upgrade to version 14, whose result contains the angle of incidence of each sighting."""
    return content | {"schema_version": 14}


def _upgrade_from_14(content: Content) -> Content:
    """Upgrade to version 15, which contains surveyed control."""
    return content | {"schema_version": 15, "control": []}


def _upgrade_from_15(content: Content) -> Content:
    """Upgrade to version 16, whose result contains the corrections of the POS.

    The POS error of a sighting was stored with the opposite sign, that of a correction.
    """
    result = content["result"]
    if result is not None:
        tests = [
            each | {"pos_error": [-value for value in each["pos_error"]]}
            for each in result["reliability"]
        ]
        result = result | {"reliability": tests}
    return content | {"schema_version": 16, "result": result}


def _upgrade_from_16(content: Content) -> Content:
    """Upgrade to version 17, whose result contains the effect of the lever arm on the angles.

    In earlier results, the lever arm is exact.
    """
    return content | {"schema_version": 17}


_UPGRADES: dict[int, Callable[[Content], Content]] = {
    1: _upgrade_from_1,
    2: _upgrade_from_2,
    3: _upgrade_from_3,
    4: _upgrade_from_4,
    5: _upgrade_from_5,
    6: _upgrade_from_6,
    7: _upgrade_from_7,
    8: _upgrade_from_8,
    9: _upgrade_from_9,
    10: _upgrade_from_10,
    11: _upgrade_from_11,
    12: _upgrade_from_12,
    13: _upgrade_from_13,
    14: _upgrade_from_14,
    15: _upgrade_from_15,
    16: _upgrade_from_16,
}
