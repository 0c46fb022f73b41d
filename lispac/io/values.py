"""Results and settings as plain values for JSON, and back, by their type annotations."""

from functools import cache
from typing import Any, TypeVar

import numpy as np

from lispac.errors import LispacError
from lispac.foreign_values import InvalidContentError
from lispac.messages import Message, error
from lispac.messages import Value as MessageValue

Value = TypeVar("Value")


@cache
def _converter() -> Any:
    from cattrs import Converter

    converter = Converter(forbid_extra_keys=True)
    converter.register_unstructure_hook_func(_is_array, lambda array: array.tolist())
    converter.register_structure_hook_func(_is_array, lambda value, _: np.array(value, dtype=float))
    converter.register_structure_hook_func(
        lambda kind: kind == MessageValue,
        lambda value, _: tuple(value) if isinstance(value, list) else value,
    )
    return converter


def _is_array(kind: Any) -> bool:
    return getattr(kind, "__origin__", kind) is np.ndarray


def encoded(value: Any) -> Any:
    """A dataclass as dictionaries, lists, numbers and text; None stays None."""
    return None if value is None else _converter().unstructure(value)


def decoded(content: Any, kind: type[Value]) -> Value:
    """The inverse of `encoded`.

    Raises
    ------
    InvalidContentError
        Where the content does not fit the type.
    """
    from cattrs.errors import BaseValidationError, ForbiddenExtraKeysError

    try:
        return _converter().structure(content, kind)
    except (BaseValidationError, ForbiddenExtraKeysError) as failure:
        raise InvalidContentError(_reason(failure, kind.__name__)) from failure


def _reason(failure: BaseException, part: str) -> Message:
    """Message about the innermost of nested errors."""
    from cattrs.errors import ForbiddenExtraKeysError

    while isinstance(failure, BaseExceptionGroup):
        failure = failure.exceptions[0]
    if isinstance(failure, ForbiddenExtraKeysError):
        return error("content.unknown_fields", part=part, names=sorted(failure.extra_fields))
    if isinstance(failure, LispacError):
        return error("content.invalid_part", part=part, reason=failure.reason)
    return error("content.wrong_form", part=part)


def in_one_line(failure: BaseException) -> str:
    """Name and first line of an error of the system or a library."""
    said = str(failure).splitlines()
    return f"{type(failure).__name__}: {said[0]}" if said else type(failure).__name__
