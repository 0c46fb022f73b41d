"""Conversion of results and settings to plain values for JSON and back, by type annotations."""

from dataclasses import is_dataclass
from functools import cache, partial
from math import inf
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from lispac.errors import LispacError
from lispac.messages import Level, Message, error
from lispac.messages import Value as MessageValue
from lispac.untrusted_values import MAX_QUANTITY, ArrayShape, InvalidContentError

Value = TypeVar("Value")


def make_converter() -> Any:
    """Make a cattrs converter of arrays, paths, messages and checked numbers."""
    from cattrs import Converter

    converter = Converter(forbid_extra_keys=True)
    converter.register_unstructure_hook_func(_is_array, _write_array)
    converter.register_unstructure_hook(Level, lambda level: level.value)
    converter.register_unstructure_hook(Path, Path.as_posix)
    converter.register_structure_hook_func(_is_array, _read_array)
    for kind, read in {
        int: _read_integer,
        float: _read_number,
        bool: _read_boolean,
        str: _read_text,
        Path: lambda value, _: Path(_read_text(value, str)),
    }.items():
        converter.register_structure_hook(kind, read)
    converter.register_structure_hook_factory(_is_tuple, partial(_tuple_reader, converter))
    converter.register_structure_hook_factory(
        _has_array_shapes, partial(_checked_reader, converter)
    )
    converter.register_structure_hook_func(
        lambda kind: kind == MessageValue,
        lambda value, _: _read_message(converter, value),
    )
    return converter


_usual_converter = cache(make_converter)


def _read_message(converter: Any, value: Any) -> Any:
    if isinstance(value, dict):
        return converter.structure(value, Message)
    if isinstance(value, list):
        return tuple(_read_message(converter, each) for each in value)
    return value


def _read_integer(value: Any, _: Any) -> int:
    if type(value) is not int:
        raise InvalidContentError(error("content.not_integer"))
    return value


def _read_number(value: Any, _: Any) -> float:
    if type(value) not in (int, float) or value != value:
        raise InvalidContentError(error("content.not_number"))
    if MAX_QUANTITY < abs(value) < inf:
        raise InvalidContentError(error("content.quantity_too_large"))
    return float(value)


def _read_boolean(value: Any, _: Any) -> bool:
    if type(value) is not bool:
        raise InvalidContentError(error("content.not_boolean"))
    return value


def _read_text(value: Any, _: Any) -> str:
    if type(value) is not str:
        raise InvalidContentError(error("content.value_not_text"))
    return value


def _is_tuple(kind: Any) -> bool:
    return get_origin(kind) is tuple


def _tuple_reader(converter: Any, kind: Any) -> Any:
    """Reader of a tuple from a list, but not from a text."""
    inner = get_args(kind)

    def read(value: Any, _: Any) -> tuple[Any, ...]:
        if not isinstance(value, list | tuple):
            raise InvalidContentError(error("content.not_list"))
        kinds = [inner[0]] * len(value) if inner[-1] is Ellipsis else list(inner)
        if len(kinds) != len(value):
            raise InvalidContentError(error("content.wrong_length"))
        return tuple(converter.structure(each, one) for each, one in zip(value, kinds, strict=True))

    return read


def _without_annotation(kind: Any) -> Any:
    return get_args(kind)[0] if get_origin(kind) is Annotated else kind


def _is_array(kind: Any) -> bool:
    return getattr(_without_annotation(kind), "__origin__", _without_annotation(kind)) is np.ndarray


def _write_array(array: NDArray[Any]) -> Any:
    """Convert an array to nested lists, with None for NaN, which JSON does not support."""
    if array.dtype.kind == "f" and np.isnan(array).any():
        content = array.astype(object)
        content[np.isnan(array)] = None
        return content.tolist()
    return array.tolist()


def _read_array(value: Any, kind: Any) -> NDArray[Any]:
    dtype = np.dtype(get_args(get_args(_without_annotation(kind))[1])[0])
    found = np.array(value) if dtype.kind in "iu" else np.array(value, dtype=object)
    if not isinstance(value, list) or any(isinstance(each, str | bool) for each in found.flat):
        raise InvalidContentError(error("content.not_numbers"))
    if dtype.kind in "iu" and found.size and found.dtype.kind not in "iu":
        raise InvalidContentError(error("content.not_integers"))
    try:
        array = np.array(value, dtype=dtype)
    except (TypeError, ValueError, OverflowError) as failure:
        raise InvalidContentError(error("content.not_numbers")) from failure
    if array.dtype.kind == "f" and (np.abs(array[np.isfinite(array)]) > MAX_QUANTITY).any():
        raise InvalidContentError(error("content.quantity_too_large"))
    return array


def _array_shapes(kind: Any) -> dict[str, ArrayShape]:
    """Annotated shapes of the arrays of a dataclass, by field."""
    if not is_dataclass(kind):
        return {}
    found = {}
    for name, hint in get_type_hints(kind, include_extras=True).items():
        for each in (hint, *get_args(hint)):
            if get_origin(each) is Annotated:
                for extra in get_args(each)[1:]:
                    if isinstance(extra, ArrayShape):
                        found[name] = extra
    return found


def _has_array_shapes(kind: Any) -> bool:
    return bool(_array_shapes(kind))


def _checked_reader(converter: Any, kind: Any) -> Any:
    """Make a reader of a dataclass that refuses arrays with other shapes than annotated."""
    from cattrs.gen import make_dict_structure_fn

    read = make_dict_structure_fn(kind, converter, _cattrs_forbid_extra_keys=True)
    shapes = _array_shapes(kind)

    def checked(value: Any, _: Any) -> Any:
        decoded = read(value, kind)
        known: dict[str, int] = {}
        for name, shape in shapes.items():
            array = getattr(decoded, name)
            if array is not None and not shape.fits(array.shape, known):
                raise InvalidContentError(error("content.wrong_shape", field=name))
        return decoded

    return checked


def encode_value(value: Any, converter: Any = None) -> Any:
    """Convert a dataclass to dictionaries, lists, numbers and text; None remains None."""
    return (converter or _usual_converter()).unstructure(value)


def decode_value(content: Any, kind: type[Value], converter: Any = None) -> Value:
    """Convert encoded content to a value of the type ``kind``.

    Parameters
    ----------
    converter : cattrs.Converter, optional
        One of `make_converter` with further hooks.

    Raises
    ------
    InvalidContentError
        If the content does not fit the type.
    """
    from cattrs.errors import BaseValidationError, ForbiddenExtraKeysError

    if is_dataclass(kind) and not isinstance(content, dict):
        raise InvalidContentError(error("content.wrong_form", part=_type_name(kind)))
    try:
        return (converter or _usual_converter()).structure(content, kind)
    except (BaseValidationError, ForbiddenExtraKeysError, InvalidContentError) as failure:
        raise InvalidContentError(_failure_message(failure, _type_name(kind))) from failure


def _type_name(kind: type[Any]) -> str:
    if isinstance(kind, UnionType):  # one that may be None
        kind = get_args(kind)[0]
    return "list" if get_origin(kind) is tuple else kind.__name__


def _failure_message(failure: BaseException, part: str) -> Message:
    """Message about the innermost of nested errors."""
    from cattrs.errors import ForbiddenExtraKeysError

    while isinstance(failure, BaseExceptionGroup):
        failure = failure.exceptions[0]
    if isinstance(failure, ForbiddenExtraKeysError):
        return error("content.unknown_fields", part=part, names=sorted(failure.extra_fields))
    if isinstance(failure, LispacError | InvalidContentError):
        return error("content.invalid_part", part=part, reason=failure.reason)
    return error("content.wrong_form", part=part)


def failure_summary(failure: BaseException) -> str:
    """Name and first line of an error of the system or a library."""
    message_lines = str(failure).splitlines()
    return (
        f"{type(failure).__name__}: {message_lines[0]}" if message_lines else type(failure).__name__
    )
