"""Former names of keys, parameters and attributes, which are accepted for one version.

The module of each file format has a table of former and new names; the functions here apply it.
"""

import functools
import inspect
import warnings
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from lispac.message_texts import message_text
from lispac.messages import Message, note

Renamed = TypeVar("Renamed", bound=Callable[..., Any])

NEW_SCRIPT_NAMES = {
    "accept_one_facing": "accept_single_orientation",
    "left_out": "excluded_outliers",
    "others": "other_surfaces",
    "raised": "angle_sigma_factors",
    "reach": "search_distance",
    "released": "rejected",
    "remarks": "messages",
    "restart": "time_rollover",
    "rms_after": "rms_after_m",
    "rms_before": "rms_before_m",
    "settled": "resolved",
    "stated_times": "given_correlation_times",
    "strays": "outliers",
    "suspect_lines": "rejected_lines",
    "suspects": "rejected_sightings",
    "test_passed": "chi_square_passed",
    "together": "all_lines",
}
"""New names of parameters and attributes that scripts use, by the former names."""
NEW_READING_OPTIONS = {"restart": "time_rollover"}
"""New names of the options for reading a file, by the former names."""


def renamed_keys(content: Any, names: Mapping[str, Mapping[str, str]], place: str = "") -> Any:
    """Content of a JSON file with its former keys replaced.

    Parameters
    ----------
    names : mapping
        New keys by former keys, for each place in the file. A place is the path of keys to an
        object, joined by points, without list indices; it is empty for the top level.
    place : str
        Place of ``content`` in the file.
    """
    if isinstance(content, list):
        return [renamed_keys(each, names, place) for each in content]
    if not isinstance(content, dict):
        return content
    new = names.get(place, {})
    return {
        new.get(key, key): renamed_keys(value, names, f"{place}.{key}" if place else key)
        for key, value in content.items()
    }


def renamed_reading(reading: Mapping[str, Any]) -> dict[str, Any]:
    """Plain values of a `Reading` with former names of options replaced."""
    options = [[NEW_READING_OPTIONS.get(name, name), value] for name, value in reading["options"]]
    return {**reading, "options": options}


def renamed_options(options: Iterable[tuple[str, str]]) -> tuple[tuple[str, str], ...]:
    """Reading options of a script with former names replaced; each replacement gives a warning."""
    return tuple((_present_option(name), value) for name, value in options)


def accept_script_names(renamed: Renamed) -> Renamed:
    """Accept former names of the parameters of a function, and of the attributes of a class."""
    if isinstance(renamed, type):
        renamed.__init__ = _with_former_parameters(renamed.__init__)  # type: ignore[misc]
        renamed.__getattr__ = _attribute_of_former_name  # type: ignore[attr-defined]
        return renamed
    return _with_former_parameters(renamed)  # type: ignore[return-value]


def _present_option(name: str) -> str:
    new = NEW_READING_OPTIONS.get(name, name)
    if new != name:
        _warn(note("former_name.script", former=name, name=new))
    return new


def _with_former_parameters(function: Callable[..., Any]) -> Callable[..., Any]:
    parameters = inspect.signature(function).parameters

    @functools.wraps(function)
    def renamed(*args: Any, **named: Any) -> Any:
        for former in named.keys() & NEW_SCRIPT_NAMES.keys() - parameters.keys():
            _warn(note("former_name.script", former=former, name=NEW_SCRIPT_NAMES[former]))
            named[NEW_SCRIPT_NAMES[former]] = named.pop(former)
        return function(*args, **named)

    return renamed


def _attribute_of_former_name(holder: Any, name: str) -> Any:
    new = NEW_SCRIPT_NAMES.get(name)
    if new is None or not hasattr(holder, new):
        raise AttributeError(f"{type(holder).__name__!r} object has no attribute {name!r}")
    _warn(note("former_name.script", former=name, name=new))
    return getattr(holder, new)


def warn_of_former_key(file: str, former: str, name: str) -> None:
    """Warn that a file uses the former name of a key."""
    _warn(note("former_name.key", file=file, former=former, name=name))


def _warn(message: Message) -> None:
    warnings.warn(message_text(message), FutureWarning, stacklevel=3)
