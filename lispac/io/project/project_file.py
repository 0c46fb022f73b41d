"""Reading and writing of a project: a folder with ``project.json`` and the points of each sighting.

``project.json`` contains paths (relative to the folder if possible), settings, targets and results.
The indices of each target's points are in ``sightings/NAME-HASH.npz``, where HASH is a digest of
the content. A new state therefore never overwrites the file that the old ``project.json`` refers
to, and a crash between the two writes leaves the old project intact. ``unsaved.json`` has the same
form and contains unsaved changes until they are saved. ``project.lispac`` opens the project by a
double click, because operating systems associate programs with file name extensions, not with
folders or with single JSON files.
"""

import hashlib
import json
import os
import re
import tokenize
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.result import AdjustmentResult
from lispac.errors import InputError, ProjectChanged, ProjectError, system_reason
from lispac.io.files import (
    atomic_write,
    bad_name_error,
    remove_abandoned_files,
    remove_empty_folders,
    write_error,
)
from lispac.io.project.project_consistency import require_consistent, require_unique_names
from lispac.io.project.project_lock import PROJECT_FILE_NAME as PROJECT_FILE_NAME
from lispac.io.project.project_lock import content_digest, project_lock
from lispac.io.project.project_upgrades import SCHEMA_VERSION, upgrade_content
from lispac.message_texts import has_text
from lispac.message_texts.former_codes import REMOVED_CODES
from lispac.messages import Message, error
from lispac.project import UNSAVED_FIELDS, PickedSighting, Project, Target
from lispac.survey.store.layout import is_link, require_no_link
from lispac.targets.finder_settings import DEFAULT_CHOICES
from lispac.targets.plane_finder import with_seed_position
from lispac.untrusted_values import InvalidContentError, json_values
from lispac.value_conversion import decode_value, encode_value, failure_summary, make_converter

UNSAVED_NAME = "unsaved.json"
SIGHTINGS_FOLDER = "sightings"
BYTES_PER_READ = 1 << 20
OPENER_NAME = "project.lispac"
OPENER_ENDING = ".lispac"
OPENER_TEXT = "This file opens the LISPAC project in its folder.\n"
IndexReader = Callable[[Path, str, Sequence[int]], Sequence[NDArray[np.int64]]]
"""Function that returns the point indices of the sightings of a target, from the path of its file
of points, the name of the target, and the number of points of each sighting."""


def write_project(project: Project, *, expected: str | None = None) -> str:
    """Write the project into its folder; the old state remains until the new one is complete.

    The recovery copy of unsaved changes is kept, because it may belong to another window or may not
    have been offered to the user yet.

    Parameters
    ----------
    expected : str, optional
        Digest that the project file on disk must have: `Project.file_digest`, or the return value
        of the last save. Without it, any project file is replaced.

    Returns
    -------
    str
        Digest of the new project file.

    Raises
    ------
    ProjectChanged
        If the file has another digest; nothing is written.
    ProjectError
        If there is a project although none was expected, or another program is changing it.
    InputError
        If the folder cannot be written.
    """
    folder, path = project.folder, project.folder / PROJECT_FILE_NAME
    with _new_folder(folder), project_lock(folder):
        if expected is not None and (found := _digest_on_disk(path)) != expected:
            if found and not expected:
                raise ProjectError(error("project.exists", folder=str(folder)))
            raise ProjectChanged(error("project.changed_on_disk", folder=str(folder)))
        used = _write_state(project, PROJECT_FILE_NAME)
        _write_opener(folder / OPENER_NAME)
        _remove_unused_files(folder, used | _unsaved_point_files(folder))
        remove_abandoned_files(path)
        return _digest_on_disk(path)


@contextmanager
def _new_folder(folder: Path) -> Iterator[None]:
    """Create a folder, and remove it again if nothing is written into it.

    Raises
    ------
    InputError
        If it cannot be created.
    """  # noqa: DOC501 - `write_error` makes an InputError
    new_folders = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except ValueError as failure:
            raise bad_name_error(folder) from failure
        yield
    except OSError as failure:
        raise write_error(folder / PROJECT_FILE_NAME, failure) from failure
    finally:
        remove_empty_folders(new_folders)


def _digest_on_disk(path: Path) -> str:
    """Digest of a project file; empty if there is none."""
    try:
        return content_digest(path.read_bytes())
    except FileNotFoundError:
        return ""


def _write_opener(path: Path) -> None:
    # The project is already saved and complete without it
    if not path.exists():
        with suppress(InputError), atomic_write(path) as temporary:
            temporary.write_text(OPENER_TEXT, encoding="utf-8")


def is_project_file(path: Path) -> bool:
    """True if a path is named like a project file or the file that opens a project."""
    return path.name == PROJECT_FILE_NAME or (path.suffix == OPENER_ENDING and not path.is_dir())


def _write_state(project: Project, name: str) -> set[str]:
    """Write a state of the project, and return the names of its files of points."""
    content = _encode_project(project)
    text = json.dumps(content, indent=1) + "\n"
    _require_readable(project, text)
    for target in project.targets:
        _write_indices(project.folder, target)
    with atomic_write(project.folder / name) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return {target["indices"] for target in content["targets"]}


def _require_readable(project: Project, text: str) -> None:
    """Refuse to write content that `read_project` would refuse.

    Raises
    ------
    ProjectError
        If the content cannot be read again; the message gives the reason.
    """
    points = {target.name: [s.indices for s in target.sightings] for target in project.targets}
    try:
        require_unique_names(project)
        _decode_text(
            project.folder / PROJECT_FILE_NAME,
            text.encode("utf-8"),
            lambda path, name, counts: points[name],
        )
    except (ProjectError, InvalidContentError) as failure:
        reason: Message | str = failure.reason
        if isinstance(failure, ProjectError) and failure.message is not None:
            inner = failure.message.params.get("reason")
            reason = inner if isinstance(inner, Message) else failure.message
        raise ProjectError(error("project.cannot_be_read_again", reason=reason)) from failure


def write_unsaved(project: Project) -> None:
    """Write a recovery copy of the unsaved project beside its saved state.

    Raises
    ------
    ProjectError
        If another program is changing the project.
    InputError
        If the folder cannot be written.
    """
    with project_lock(project.folder):
        _write_state(project, UNSAVED_NAME)


def remove_unsaved(folder: Path) -> None:
    """Remove the recovery copy of a project; its points are removed with the next save."""
    with suppress(OSError):
        (folder / UNSAVED_NAME).unlink(missing_ok=True)


def read_unsaved(folder: Path) -> Project | None:
    """Read the unsaved project after a crash; None if there is none.

    Raises
    ------
    ProjectError
        If it is damaged.
    """
    path = folder / UNSAVED_NAME
    # After a crash between save and removal, the copy has the same content
    if not path.is_file() or path.read_bytes() == (folder / PROJECT_FILE_NAME).read_bytes():
        return None
    return _read_state(path)


def read_project(folder: Path) -> Project:
    """Read a project from its folder, its ``project.json`` or the file that opens it.

    Raises
    ------
    ProjectError
        If there is no project, or its file is damaged or of a newer version.
    """
    path = project_folder(folder) / PROJECT_FILE_NAME
    project = _read_state(path)
    remove_abandoned_files(path)
    return project


def project_folder(path: Path) -> Path:
    """Folder of a project, from the folder, its ``project.json`` or the file that opens it.

    Raises
    ------
    ProjectError
        If there is no project, or it cannot be searched for.
    """  # noqa: DOC501 - `_unreadable_error` makes a ProjectError
    path = Path(path)
    try:
        folder = path.parent if is_project_file(path) else path
        is_project = (folder / PROJECT_FILE_NAME).is_file()
    except OSError as failure:  # no permission to read it, or too long a name
        raise _unreadable_error(path, failure) from failure
    if not is_project:
        raise ProjectError(error("project.not_found", folder=str(path), missing=PROJECT_FILE_NAME))
    return folder


def _read_state(path: Path) -> Project:
    """Read a state of a project, and retry if another program saves it at the same time.

    A save removes the files of points of the previous state, which may be missing while reading.

    Raises
    ------
    ProjectError
        If the state or its points are missing or damaged.
    """  # noqa: DOC501 - `_unreadable_error` makes a ProjectError
    while True:
        try:
            content = path.read_bytes()
        except OSError as failure:
            raise _unreadable_error(path, failure) from failure
        try:
            return replace(_decode_text(path, content), file_digest=content_digest(content))
        except ProjectError:
            if _digest_on_disk(path) in ("", content_digest(content)):
                raise


def _unreadable_error(path: Path, failure: OSError) -> ProjectError:
    """Make the error of a project that cannot be read."""
    reason = system_reason(failure)
    return ProjectError(error("project.unreadable", file=str(path), reason=reason))


def _decode_text(path: Path, text: bytes, points: IndexReader | None = None) -> Project:
    try:
        content = json_values(text)
        version = content["schema_version"]
        if type(version) is not int or version < 1:
            raise InvalidContentError(error("content.invalid_version", version=repr(version)[:40]))
        if version > SCHEMA_VERSION:
            raise ProjectError(error("project.newer_version", file=str(path), version=version))
        project = _decode_project(
            path.parent.resolve(), upgrade_content(content), points or _read_indices
        )
        require_consistent(project)
    except InputError as failure:
        raise ProjectError(
            error("project.invalid_value", file=str(path), reason=failure.reason)
        ) from failure
    except (
        ValueError, KeyError, TypeError, AttributeError, IndexError, OverflowError,
    ) as failure:  # fmt: skip
        raise ProjectError(
            error("project.damaged", file=str(path), reason=_damage_message(failure))
        ) from failure
    return project


def _damage_message(failure: Exception) -> Message:
    """Message about the invalid content of a project file."""
    if isinstance(failure, KeyError):
        return error("content.missing_field", field=str(failure.args[0]))
    if isinstance(failure, InvalidContentError):
        return failure.reason
    return error("content.wrong_type")


@cache
def _file_converter() -> Any:
    """Converter of the parts of a project; the points of a sighting are in a file of their own.

    When it writes, the file contains their number. When it reads, `_with_point_indices` has
    replaced the number by the points.
    """
    from cattrs.gen import make_dict_structure_fn, make_dict_unstructure_fn, override

    converter = make_converter()
    unchanged = override(struct_hook=lambda value, _: value)
    sighting: dict[str, Any] = {
        "indices": override(rename="points", unstruct_hook=len, struct_hook=unchanged.struct_hook),
        "by_hand": override(omit_if_default=True),
    }
    # `require_consistent` refuses unknown roles and shapes, with the name of the target
    target: dict[str, Any] = {
        "role": unchanged,
        "shape": unchanged,
        "choices": override(
            unstruct_hook=lambda value: None if value == DEFAULT_CHOICES else encode_value(value),
            struct_hook=lambda content, kind: (
                decode_value(content, kind) if content else DEFAULT_CHOICES
            ),
        ),
    }
    read_message = make_dict_structure_fn(Message, converter, _cattrs_forbid_extra_keys=True)
    converter.register_structure_hook(
        Message, lambda content, kind: with_seed_position(read_message(content, kind))
    )
    for kind, fields in ((PickedSighting, sighting), (Target, target)):
        converter.register_unstructure_hook(
            kind, make_dict_unstructure_fn(kind, converter, **fields)
        )
        converter.register_structure_hook(kind, make_dict_structure_fn(kind, converter, **fields))
    return converter


@cache
def _stored_fields() -> dict[str, Any]:
    """Types of the fields of a project that are in its file, in the order of the file."""
    kinds = get_type_hints(Project, include_extras=True)
    return {name: kind for name, kind in kinds.items() if name not in UNSAVED_FIELDS}


OPTIONAL_FIELDS = frozenset({"absolute", "data_messages", "reading_warnings", "prediction"})
"""Fields that may be missing in the file, because earlier programs wrote this version without."""


def _encode_project(project: Project) -> dict[str, Any]:
    stored = _with_paths(project, lambda path: _relative_path(path, project.folder))
    content = {
        name: encode_value(getattr(stored, name), _file_converter()) for name in _stored_fields()
    }
    for target, encoded in zip(project.targets, content["targets"], strict=True):
        sightings = encoded.pop("sightings")
        encoded |= {"indices": _indices_file_name(target), "sightings": sightings}
    return {"schema_version": SCHEMA_VERSION, **content}


def _decode_project(folder: Path, content: dict[str, Any], points: IndexReader) -> Project:
    """Decode the present version of the content.

    Messages of another version, which have no text in this one, are omitted.
    """
    targets = [_with_point_indices(each, folder, points) for each in content["targets"]]
    content = content | {"targets": targets}
    values = {
        name: decode_value(content[name], kind, _file_converter())
        for name, kind in _stored_fields().items()
        if name in content or name not in OPTIONAL_FIELDS
    }
    stored = Project(folder=folder, **values)
    return replace(
        _with_paths(stored, lambda path: _absolute_path(path, folder)),
        data_messages=tuple(each for each in stored.data_messages if has_text(each)),
        reading_warnings=tuple(each for each in stored.reading_warnings if has_text(each)),
        result=_with_present_messages(stored.result),
    )


def _with_present_messages(result: AdjustmentResult | None) -> AdjustmentResult | None:
    """Result with the present message instead of those of `REMOVED_CODES`."""
    if result is None or result.observability is None:
        return result
    found = result.observability
    place = next((k for k, m in enumerate(found.messages) if m.code in REMOVED_CODES), None)
    if place is None:
        return result
    from lispac.adjustment.diagnostics.observability import largest_increases_note

    new = largest_increases_note(result.sigma, found.sigma_without_line)
    later = (each for each in found.messages[place:] if each.code not in REMOVED_CODES)
    return replace(
        result, observability=replace(found, messages=(*found.messages[:place], *new, *later))
    )


def _with_paths(project: Project, convert: Callable[[Path], Path]) -> Project:
    return replace(
        project,
        trajectory=convert(project.trajectory),
        accuracy=project.accuracy and convert(project.accuracy),
        lines=tuple(replace(line, path=convert(line.path)) for line in project.lines),
        control=tuple(replace(file, path=convert(file.path)) for file in project.control),
    )


def _with_point_indices(target: Any, folder: Path, points: IndexReader) -> dict[str, Any]:
    """Content of a target with the indices of its points instead of the name of their file."""
    name, file_name = (decode_value(target[key], str) for key in ("name", "indices"))
    sightings = target["sightings"]
    indices = points(folder / file_name, name, [_point_count(each) for each in sightings])
    return {key: value for key, value in target.items() if key != "indices"} | {
        "sightings": [each | {"points": own} for each, own in zip(sightings, indices, strict=True)]
    }


def _point_count(sighting: dict[str, Any]) -> int:
    """Number of points of a sighting.

    Raises
    ------
    InvalidContentError
        If the count is not an integer of 0 or more.
    """
    count = sighting["points"]
    if isinstance(count, bool) or not isinstance(count, int) or count < 0:
        raise InvalidContentError(error("content.invalid_point_count"))
    return count


INDEX_BYTES = 8
MAX_ARRAY_HEADER_BYTES = 4096
"""Largest number of bytes of the header of an array in a NumPy file."""
DAMAGED_FILE_ERRORS = (
    OSError, ValueError, KeyError, EOFError, MemoryError, RuntimeError, SyntaxError,
    tokenize.TokenError, zipfile.BadZipFile, zlib.error,
)  # fmt: skip
"""Exceptions that numpy and zipfile raise for a damaged file."""


def _read_indices(path: Path, target: str, points: Sequence[int]) -> list[NDArray[np.int64]]:
    """Read the point indices of each sighting; ``points`` are the expected numbers of points.

    Raises
    ------
    ProjectError
        If the file of points is missing or damaged, or does not match the project.
    """  # noqa: DOC501 - its own InvalidContentError is caught
    try:
        if not path.is_file():
            raise ProjectError(error("project.points_missing", file=str(path), target=target))
        # Opened here, because numpy leaves a file open if it is not valid.
        with path.open("rb") as file, np.load(file) as arrays:
            found = []
            for k, count in enumerate(points):
                # Checked before unpacking, because a small file may state any size
                size = arrays.zip.getinfo(f"line{k}.npy").file_size
                if size > INDEX_BYTES * count + MAX_ARRAY_HEADER_BYTES:
                    raise InvalidContentError(
                        error("content.too_many_bytes", bytes=size, count=count)
                    )
                found.append(arrays[f"line{k}"])
        for indices, count in zip(found, points, strict=True):
            if indices.ndim != 1 or indices.dtype.kind not in "iu" or (indices < 0).any():
                raise InvalidContentError(error("content.not_indices"))
            if len(indices) != count:
                raise InvalidContentError(
                    error("content.too_few_points", held=len(indices), count=count)
                )
    except InvalidContentError as failure:
        raise ProjectError(
            error("project.points_damaged", file=str(path), target=target, reason=failure.reason)
        ) from failure
    except PermissionError as failure:
        raise _unreadable_error(path, failure) from failure
    except DAMAGED_FILE_ERRORS as failure:
        reason = error("content.unreadable", reason=failure_summary(failure))
        raise ProjectError(
            error("project.points_damaged", file=str(path), target=target, reason=reason)
        ) from failure
    return found


def _indices_file_name(target: Target) -> str:
    """Name of the file of the points of a target, in the folder of the project."""
    plain = re.sub(r"[^A-Za-z0-9_-]", "_", target.name)
    return f"{SIGHTINGS_FOLDER}/{plain}-{_arrays_digest(s.indices for s in target.sightings)}.npz"


def _write_indices(folder: Path, target: Target) -> None:
    arrays: dict[str, NDArray[Any]] = {
        f"line{k}": sighting.indices for k, sighting in enumerate(target.sightings)
    }
    name = _indices_file_name(target)
    require_no_link(folder / SIGHTINGS_FOLDER)
    if not (folder / name).exists():
        buffer = BytesIO()
        np.savez_compressed(buffer, **arrays)  # type: ignore[arg-type]
        with atomic_write(folder / name) as temporary:
            temporary.write_bytes(buffer.getvalue())


def _arrays_digest(arrays: Iterable[NDArray[Any]]) -> str:
    """Digest of the content of a file of points, which is part of its name."""
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(array.tobytes() + b"|")
    return digest.hexdigest()[:16]


def _unsaved_point_files(folder: Path) -> set[str]:
    """Names of the files of points that the unsaved project uses."""
    try:
        content = json_values((folder / UNSAVED_NAME).read_bytes())
        return {target["indices"] for target in content["targets"]}
    except (OSError, ValueError, KeyError, TypeError):
        return set()  # there is no unsaved project, or it cannot be read


def _remove_unused_files(folder: Path, used: set[str]) -> None:
    """Remove the program's own files of points that no state uses."""
    if is_link(folder / SIGHTINGS_FOLDER):
        return
    for path in (folder / SIGHTINGS_FOLDER).glob("*.npz"):
        if f"{SIGHTINGS_FOLDER}/{path.name}" not in used and _has_named_content(path):
            path.unlink(missing_ok=True)


def remove_point_files(folder: Path) -> None:
    """Remove all files of points of a project that is replaced, but no files of the user."""
    _remove_unused_files(folder, set())
    if not is_link(folder / SIGHTINGS_FOLDER):
        remove_empty_folders([folder / SIGHTINGS_FOLDER])


def _has_named_content(path: Path) -> bool:
    """True if the content of a file of points matches the digest in its name."""
    named = re.fullmatch(r"[A-Za-z0-9_-]*-([0-9a-f]{16})\.npz", path.name)
    if named is None or is_link(path) or not path.is_file():
        return False
    try:
        with zipfile.ZipFile(path) as arrays:
            names = sorted(
                arrays.namelist(), key=lambda name: int(name[len("line") : -len(".npy")])
            )
            digest = hashlib.sha256()
            for name in names:
                with arrays.open(name) as file:
                    np.lib.format.read_magic(file)
                    np.lib.format.read_array_header_1_0(file)
                    while block := file.read(
                        BYTES_PER_READ
                    ):  # a damaged file may unpack to any size
                        digest.update(block)
                digest.update(b"|")
            return digest.hexdigest()[:16] == named[1]
    except DAMAGED_FILE_ERRORS:
        return False


def _relative_path(path: Path, folder: Path) -> Path:
    try:
        return Path(os.path.relpath(path, folder))
    except ValueError:  # another drive on Windows
        return path


def _absolute_path(path: Path, folder: Path) -> Path:
    # Lexical, not resolved: a file reached through a link keeps the name the user knows.
    return Path(os.path.normpath(folder / path))
