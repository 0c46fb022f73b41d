"""Results and settings as plain values for JSON, and back, by their type annotations."""

import re
from functools import cache
from typing import Any, TypeVar

import numpy as np

from lispac.errors import LispacError
from lispac.foreign_values import Unfit as Unfit
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
    Unfit
        Where the content does not fit the type.
    """
    from cattrs.errors import BaseValidationError, ForbiddenExtraKeysError

    try:
        return _converter().structure(content, kind)
    except (BaseValidationError, ForbiddenExtraKeysError) as error:
        raise Unfit(f"its {_in_words(kind)} cannot be read{_reason(error)}") from error


def _in_words(kind: type[Any]) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind.__name__).lower()


def _reason(error: BaseException) -> str:
    """The innermost of nested errors where it says something to those who do not know the code."""
    from cattrs.errors import ForbiddenExtraKeysError

    while isinstance(error, BaseExceptionGroup):
        error = error.exceptions[0]
    if isinstance(error, ForbiddenExtraKeysError):
        return f": {', '.join(sorted(error.extra_fields))} is not known"
    return f": {error}" if isinstance(error, LispacError) else ""


def in_one_line(error: BaseException) -> str:
    """What an error of the system or a library is called and says, in one line."""
    said = str(error).splitlines()
    return f"{type(error).__name__}: {said[0]}" if said else type(error).__name__
