"""Results and settings as plain values for JSON, and back, by their type annotations."""

import re
from dataclasses import is_dataclass
from functools import cache, partial
from math import inf
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.foreign_values import Shape
from lispac.foreign_values import Unfit as Unfit
from lispac.messages import Message
from lispac.messages import Value as MessageValue

Value = TypeVar("Value")

LARGEST_NUMBER = 1e30
"""No quantity of a survey is larger, and squares of larger ones overflow sooner or later."""


@cache
def _converter() -> Any:
    from cattrs import Converter

    converter = Converter(forbid_extra_keys=True)
    converter.register_unstructure_hook_func(_is_array, _array_content)
    converter.register_structure_hook_func(_is_array, _array)
    for kind, read in {int: _integer, float: _number, bool: _truth, str: _text}.items():
        converter.register_structure_hook(kind, read)
    converter.register_structure_hook_factory(_is_tuple, partial(_tuple_reader, converter))
    converter.register_structure_hook_factory(_has_shapes, partial(_checked_reader, converter))
    converter.register_structure_hook_func(
        lambda kind: kind == MessageValue,
        lambda value, _: _message_value(converter, value),
    )
    return converter


def _message_value(converter: Any, value: Any) -> Any:
    if isinstance(value, dict):
        return converter.structure(value, Message)
    return tuple(value) if isinstance(value, list) else value


def _integer(value: Any, _: Any) -> int:
    if type(value) is not int:
        raise Unfit("a count is not an integer")
    return value


def _number(value: Any, _: Any) -> float:
    if type(value) not in (int, float) or value != value:
        raise Unfit("a value is not a number")
    if LARGEST_NUMBER < abs(value) < inf:
        raise Unfit("a number in it is too large")
    return float(value)


def _truth(value: Any, _: Any) -> bool:
    if type(value) is not bool:
        raise Unfit("a value is not true or false")
    return value


def _text(value: Any, _: Any) -> str:
    if type(value) is not str:
        raise Unfit("a value is not text")
    return value


def _is_tuple(kind: Any) -> bool:
    return get_origin(kind) is tuple


def _tuple_reader(converter: Any, kind: Any) -> Any:
    """Reads a tuple from a list alone: a text would be one of letters."""
    inner = get_args(kind)

    def read(value: Any, _: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple):
            raise Unfit("a value is not a list")
        kinds = [inner[0]] * len(value) if inner[-1] is Ellipsis else list(inner)
        if len(kinds) != len(value):
            raise Unfit("a list has another length")
        return tuple(converter.structure(each, one) for each, one in zip(value, kinds, strict=True))

    return read


def _bare(kind: Any) -> Any:
    return get_args(kind)[0] if get_origin(kind) is Annotated else kind


def _is_array(kind: Any) -> bool:
    return getattr(_bare(kind), "__origin__", _bare(kind)) is np.ndarray


def _array_content(array: NDArray[Any]) -> Any:
    """Nested lists; None for NaN, which JSON lacks."""
    if array.dtype.kind == "f" and np.isnan(array).any():
        content = array.astype(object)
        content[np.isnan(array)] = None
        return content.tolist()
    return array.tolist()


def _array(value: Any, kind: Any) -> NDArray[Any]:
    dtype = np.dtype(get_args(get_args(_bare(kind))[1])[0])
    found = np.array(value) if dtype.kind in "iu" else np.array(value, dtype=object)
    if not isinstance(value, list) or any(isinstance(each, str | bool) for each in found.flat):
        raise Unfit("a list has values that are not numbers")
    if dtype.kind in "iu" and found.size and found.dtype.kind not in "iu":
        raise Unfit("a list has values that are not integers")
    try:
        array = np.array(value, dtype=dtype)
    except (TypeError, ValueError, OverflowError) as error:
        raise Unfit("a list has values that are not numbers") from error
    if array.dtype.kind == "f" and (np.abs(array[np.isfinite(array)]) > LARGEST_NUMBER).any():
        raise Unfit("a number in it is too large")
    return array


def _shapes(kind: Any) -> dict[str, Shape]:
    """Shapes of the arrays of a dataclass, by the fields."""
    if not is_dataclass(kind):
        return {}
    found = {}
    for name, hint in get_type_hints(kind, include_extras=True).items():
        for each in (hint, *get_args(hint)):
            if get_origin(each) is Annotated:
                for extra in get_args(each)[1:]:
                    if isinstance(extra, Shape):
                        found[name] = extra
    return found


def _has_shapes(kind: Any) -> bool:
    return bool(_shapes(kind))


def _checked_reader(converter: Any, kind: Any) -> Any:
    """Reads a dataclass, and refuses it where its arrays have other shapes than stated."""
    from cattrs.gen import make_dict_structure_fn

    read = make_dict_structure_fn(kind, converter, _cattrs_forbid_extra_keys=True)
    shapes = _shapes(kind)

    def checked(value: Any, _: Any) -> Any:
        made = read(value, kind)
        known: dict[str, int] = {}
        for name, shape in shapes.items():
            array = getattr(made, name)
            if array is not None and not shape.fits(array.shape, known):
                raise Unfit(f"{name} has another shape than it must have")
        return made

    return checked


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
    except (BaseValidationError, ForbiddenExtraKeysError, Unfit) as error:
        raise Unfit(f"its {_in_words(kind)} cannot be read{_reason(error)}") from error


def _in_words(kind: type[Any]) -> str:
    if get_origin(kind) is tuple:
        return "list"
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind.__name__).lower()


def _reason(error: BaseException) -> str:
    """The innermost of nested errors where it says something to those who do not know the code."""
    from cattrs.errors import ForbiddenExtraKeysError

    while isinstance(error, BaseExceptionGroup):
        error = error.exceptions[0]
    if isinstance(error, ForbiddenExtraKeysError):
        return f": {', '.join(sorted(error.extra_fields))} is not known"
    return f": {error}" if isinstance(error, LispacError | Unfit) else ""


def in_one_line(error: BaseException) -> str:
    """What an error of the system or a library is called and says, in one line."""
    said = str(error).splitlines()
    return f"{type(error).__name__}: {said[0]}" if said else type(error).__name__
