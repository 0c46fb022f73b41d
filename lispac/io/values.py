"""Results and settings as plain values for JSON, and back, by their type annotations."""

from dataclasses import is_dataclass
from functools import cache, partial
from math import inf
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.foreign_values import LARGEST_QUANTITY, InvalidContentError, Shape
from lispac.messages import Level, Message, error
from lispac.messages import Value as MessageValue

Value = TypeVar("Value")


@cache
def _converter() -> Any:
    from cattrs import Converter

    converter = Converter(forbid_extra_keys=True)
    converter.register_unstructure_hook_func(_is_array, _array_content)
    converter.register_unstructure_hook(Level, lambda level: level.value)
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
    if isinstance(value, list):
        return tuple(_message_value(converter, each) for each in value)
    return value


def _integer(value: Any, _: Any) -> int:
    if type(value) is not int:
        raise InvalidContentError(error("content.not_integer"))
    return value


def _number(value: Any, _: Any) -> float:
    if type(value) not in (int, float) or value != value:
        raise InvalidContentError(error("content.not_number"))
    if LARGEST_QUANTITY < abs(value) < inf:
        raise InvalidContentError(error("content.quantity_too_large"))
    return float(value)


def _truth(value: Any, _: Any) -> bool:
    if type(value) is not bool:
        raise InvalidContentError(error("content.not_boolean"))
    return value


def _text(value: Any, _: Any) -> str:
    if type(value) is not str:
        raise InvalidContentError(error("content.value_not_text"))
    return value


def _is_tuple(kind: Any) -> bool:
    return get_origin(kind) is tuple


def _tuple_reader(converter: Any, kind: Any) -> Any:
    """Reads a tuple from a list alone: a text would be one of letters."""
    inner = get_args(kind)

    def read(value: Any, _: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple):
            raise InvalidContentError(error("content.not_list"))
        kinds = [inner[0]] * len(value) if inner[-1] is Ellipsis else list(inner)
        if len(kinds) != len(value):
            raise InvalidContentError(error("content.wrong_length"))
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
        raise InvalidContentError(error("content.not_numbers"))
    if dtype.kind in "iu" and found.size and found.dtype.kind not in "iu":
        raise InvalidContentError(error("content.not_integers"))
    try:
        array = np.array(value, dtype=dtype)
    except (TypeError, ValueError, OverflowError) as failure:
        raise InvalidContentError(error("content.not_numbers")) from failure
    if array.dtype.kind == "f" and (np.abs(array[np.isfinite(array)]) > LARGEST_QUANTITY).any():
        raise InvalidContentError(error("content.quantity_too_large"))
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
    """Reads a dataclass, and refuses it where its arrays have other shapes than given."""
    from cattrs.gen import make_dict_structure_fn

    read = make_dict_structure_fn(kind, converter, _cattrs_forbid_extra_keys=True)
    shapes = _shapes(kind)

    def checked(value: Any, _: Any) -> Any:
        made = read(value, kind)
        known: dict[str, int] = {}
        for name, shape in shapes.items():
            array = getattr(made, name)
            if array is not None and not shape.fits(array.shape, known):
                raise InvalidContentError(error("content.wrong_shape", field=name))
        return made

    return checked


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
    except (BaseValidationError, ForbiddenExtraKeysError, InvalidContentError) as failure:
        raise InvalidContentError(_reason(failure, _name_of(kind))) from failure


def _name_of(kind: type[Any]) -> str:
    return "list" if get_origin(kind) is tuple else kind.__name__


def _reason(failure: BaseException, part: str) -> Message:
    """Message about the innermost of nested errors."""
    from cattrs.errors import ForbiddenExtraKeysError

    while isinstance(failure, BaseExceptionGroup):
        failure = failure.exceptions[0]
    if isinstance(failure, ForbiddenExtraKeysError):
        return error("content.unknown_fields", part=part, names=sorted(failure.extra_fields))
    if isinstance(failure, LispacError | InvalidContentError):
        return error("content.invalid_part", part=part, reason=failure.reason)
    return error("content.wrong_form", part=part)


def in_one_line(failure: BaseException) -> str:
    """Name and first line of an error of the system or a library."""
    said = str(failure).splitlines()
    return f"{type(failure).__name__}: {said[0]}" if said else type(failure).__name__
