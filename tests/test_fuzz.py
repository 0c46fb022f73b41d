"""Every reader before made and damaged files: only the program's own errors come out."""

import json
import shutil
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pytest
from hypothesis import strategies as st

from lispac.errors import Cancelled, LispacError
from lispac.gui.settings import AppSettings
from lispac.io.formats import ACCURACIES, POINTS, TRAJECTORIES, format_of
from lispac.io.project_file import FILE_NAME, read_project, write_project
from lispac.io.registry import Finding
from lispac.io.seed_file import looks_like_a_list, read_point_list
from lispac.io.static_scan import static_scan
from lispac.survey.store import layout
from lispac.survey.store.reading import open_store
from lispac.survey.store.writing import write_store
from lispac.targets.settings import FinderChoices
from tests import point_files
from tests.fuzzing import Attempt, damaged, fuzz, fuzz_long, json_like
from tests.report_sample import sample_project
from tests.static_scans import write_pts
from tests.store_lines import RECIPE, Line, files_of, place, small, stop_at
from tests.test_trajectory_bad_input import anything, good

__all__ = ["small"]

FORMATS = {format.key: format for format in (*TRAJECTORIES, *ACCURACIES, *POINTS)}
SHORT = 15

Sources = list[st.SearchStrategy[bytes]]
Subject = Callable[[Path], tuple[Sources, Attempt]]


def said_by(task: Callable[[], object]) -> str | None:
    """What a task refuses with; None where it ends well. All other errors come through."""
    told = None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            task()
    except LispacError as refused:
        told = str(refused)
    assert told is None or "\n" not in told
    return told


def read_wholly(key: str, path: Path, choice: Any) -> None:
    """Read a file to its end; what is given is made of numbers."""
    result = FORMATS[key].read(path, choice)
    if FORMATS[key].kind != "points":
        assert np.isfinite(result.time).all()  # type: ignore[union-attr]
        return
    for chunk in result:  # type: ignore[union-attr]
        assert np.isfinite(chunk.xyz).all()
        assert np.isfinite(chunk.time).all()


def of_format(key: str) -> Subject:
    def subject(folder: Path) -> tuple[Sources, Attempt]:
        if FORMATS[key].kind == "points":
            sound = [
                write(folder / name)
                for name, (format, write) in point_files.VALID.items()
                if format == key
            ]
        else:
            made = point_files.cidco if key.startswith("cidco") else partial(good, key)
            sound = [made(folder / "sound")]
        path = folder / f"any{sound[0].suffix}"

        def attempt(content: bytes) -> bool:
            path.write_bytes(content)
            assert 0 <= FORMATS[key].sniff(path) <= 1
            findings: list[Finding] = []
            said_by(lambda: findings.append(FORMATS[key].look(path, {})))
            refusals = [
                said_by(lambda choice=choice: read_wholly(key, path, choice))  # type: ignore[misc]
                for choice in ({}, *(finding.choice for finding in findings))
            ]
            assert not any(told for told in refusals if told and str(path) not in told)
            return None in refusals

        changed = [damaged(file.read_bytes()) for file in sound]
        return [*changed, *changed, anything], attempt

    return subject


ORDER = ["time", "latitude", "longitude", "height", "roll", "pitch", "heading"]


def columns_of(key: str) -> Subject:
    """The column mapping of a sound file, as the user or the project file has it."""

    def subject(folder: Path) -> tuple[Sources, Attempt]:
        named = key == "text"
        path = point_files.text(folder / "a.csv") if named else good(key, folder / "a.txt")
        roles = [
            "time", "date", "x", "y", "z", "latitude", "longitude", "easting", "height",
            "sea_height", "roll", "pitch", "heading", "sroll", "-", "", "intensity",
        ]  # fmt: skip
        whole = ["time", "x", "y", "z", "-"] if named else ORDER
        words = st.one_of(
            st.lists(st.sampled_from(roles) | st.text(max_size=5), max_size=9),
            st.permutations(whole),
            st.lists(st.sampled_from(roles), max_size=2).map(lambda more: [*whole, *more]),
        )
        said = st.builds(str.join, st.sampled_from([" ", ",", ", "]), words) | st.text(max_size=30)

        def attempt(content: bytes) -> bool:
            choice = {"columns": content.decode("utf-8", "surrogatepass")}
            said_by(lambda: FORMATS[key].look(path, choice))
            return said_by(lambda: read_wholly(key, path, choice)) is None

        return [said.map(lambda text: text.encode("utf-8", "surrogatepass"))], attempt

    return subject


def remembered(folder: Path) -> tuple[Sources, Attempt]:
    """What the window remembers, column mappings among it."""
    path = folder / "window.ini"
    sound = AppSettings(path)
    sound.keep_column_mappings({"text/5/": "time x y z -", "ascii-trajectory/9/": "time roll"})
    sound.add_recent(folder)
    sound.point_size = 3
    sound.sync()
    content = path.read_bytes()

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        kept = AppSettings(path)
        mappings = kept.column_mappings()
        assert all(isinstance(text, str) for pair in mappings.items() for text in pair)
        assert isinstance(kept.point_size, int)
        assert all(isinstance(path, Path) for path in kept.recent())
        kept.layout()
        return bool(mappings)

    number = st.characters(categories=["Nd", "No", "Nl"]).map(
        lambda digit: f"[General]\npoint_size={digit}\n".encode()
    )
    return [damaged(content), anything, number], attempt


def project(folder: Path) -> tuple[Sources, Attempt]:
    made = sample_project(folder / "p")
    first = replace(made.targets[0], choices=FinderChoices(min_points=50))
    write_project(replace(made, targets=(first, *made.targets[1:])))
    path = folder / "p" / FILE_NAME

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return said_by(lambda: read_project(path)) is None

    return [json_like(path.read_bytes()), anything], attempt


def sightings(folder: Path) -> tuple[Sources, Attempt]:
    """The picked points beside a project file."""
    write_project(sample_project(folder / "p"))
    path = next((folder / "p" / "sightings").glob("*.npz"))

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return said_by(lambda: read_project(folder / "p")) is None

    return [damaged(path.read_bytes()), anything], attempt


def coordinate_list(folder: Path) -> tuple[Sources, Attempt]:
    """A list of target coordinates, read for the local frame and for a map."""
    path = folder / "targets.txt"
    sound = [
        b"# measured\nname;north;west;up;role\nT1;1,5;-2,5;3,5;T\nV1;4,5;5,5;6,5;validation\n",
        b"101 12.5 -3.25 1e1 board\n102 12.5 -3.5 10\n",
        'name,lat,lon,h\n"T 1",45\N{DEGREE SIGN}30\'15.5"N,W073:12:08,3\n'.encode(),
    ]

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        looks_like_a_list(path)
        refusals = [
            said_by(lambda local=local, columns=columns: read_point_list(  # type: ignore[misc]
                path, columns=columns, local=local, degrees=not local
            ))
            for local in (True, False)
            for columns in ((), ("name", "x", "y", "z"))
        ]  # fmt: skip
        assert all(str(path) in told for told in refusals if told)
        return None in refusals

    word = st.sampled_from(["T1", "V2", "1.5", "-2,5", "1e400", "x", "name", "#", '"', "", "t"])
    mark = st.sampled_from([",", ";", "\t", " ", "\n", "\r", ", "])
    made = st.lists(st.tuples(word, mark), max_size=40).map(
        lambda parts: "".join(text for pair in parts for text in pair).encode()
    )
    return [*(damaged(content) for content in sound), made, anything], attempt


def static_scans(folder: Path) -> tuple[Sources, Attempt]:
    """PTS, which is read without time and so is in no list of formats."""
    path = write_pts(folder / "scan.pts", [point_files.XYZ[:4], point_files.XYZ[4:9]])

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)

        def read() -> None:
            for chunk in static_scan(path).chunks(local=True):
                assert np.isfinite(chunk).all()

        told = said_by(read)
        assert told is None or str(path) in told
        return told is None

    word = st.sampled_from(["1", "2", "0", "-7", "1.5", "1e400", "nan", "1_0", "1,5", "#", "x"])
    mark = st.sampled_from([" ", "\t", "\n", "\r\n", "\r"])
    made = st.lists(st.tuples(word, mark), max_size=40).map(
        lambda parts: "".join(text for pair in parts for text in pair).encode()
    )
    return [damaged(path.read_bytes()), made, anything], attempt


LINE = Line(2_500)


def stored(folder: Path) -> None:
    write_store(folder, RECIPE, LINE.pieces(200), place)


def used(folder: Path) -> None:
    """Open a store and take all of it."""
    found = open_store(folder, "L1")
    for values in (found.points_lidar, found.time, *found.extra.values(), found.coarse.rows):
        np.asarray(values).tobytes()
    assert found.numbers(np.arange(3)).shape == (3,)
    with warnings.catch_warnings():
        # Only the checksum of the whole tells of other numbers; any may be in there.
        warnings.simplefilter("ignore", RuntimeWarning)
        found.within(np.zeros(3), 5.0, place)
    found.require_sound()


def manifest(folder: Path) -> tuple[Sources, Attempt]:
    """Damaged, or changed by somebody who also puts the checksum right."""
    stored(folder / "L1")
    path = folder / "L1" / layout.MANIFEST

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return said_by(lambda: used(folder / "L1")) is None

    def summed(content: bytes) -> bytes:
        try:
            whole = json.loads(content)
            store = json.dumps(whole["store"], sort_keys=True).encode()
            return json.dumps(whole | {"checksum": crc32(store)}).encode()
        except (ValueError, TypeError, KeyError, RecursionError):
            return content

    made = json_like(path.read_bytes())
    return [made, made.map(summed), anything], attempt


def columns(folder: Path) -> tuple[Sources, Attempt]:
    """Column files of the right size; another one is seen at once."""
    stored(folder / "L1")
    paths = sorted((folder / "L1").glob("columns-*/*.npy"))
    sound = [path.read_bytes() for path in paths]

    def attempt(content: bytes) -> bool:
        number, content = content[0] % len(paths), content[1:]
        whole = sound[number]
        paths[number].write_bytes((content + whole[len(content) :])[: len(whole)])
        try:
            return said_by(lambda: used(folder / "L1")) is None
        finally:
            paths[number].write_bytes(whole)

    def of_one(number: int) -> st.SearchStrategy[bytes]:
        return damaged(sound[number]).map(lambda content: bytes([number]) + content)

    numbers = st.integers(0, len(paths) - 1)
    any_of_them = st.builds(lambda k, made: bytes([k]) + made, numbers, anything)
    return [numbers.flatmap(of_one), any_of_them], attempt


def spool(folder: Path) -> tuple[Sources, Attempt]:
    """What an interrupted import has left: used where it is whole, else read again."""
    stored(folder / "whole")
    expected = files_of(open_store(folder / "whole", "L1").manifest)
    with pytest.raises(Cancelled):
        write_store(folder / "half", RECIPE, LINE.pieces(200), place, progress=stop_at(15))
    files = sorted((folder / "half" / layout.SPOOL).iterdir())
    assert {"block-00002.json", "complete.json", "recipe.json"} <= {file.name for file in files}

    def attempt(content: bytes) -> bool:
        shutil.rmtree(folder / "L1", ignore_errors=True)
        shutil.copytree(folder / "half", folder / "L1")
        (folder / "L1" / layout.SPOOL / files[content[0] % len(files)].name).write_bytes(
            content[1:]
        )
        told = said_by(lambda: stored(folder / "L1"))
        assert told is None
        assert files_of(open_store(folder / "L1", "L1").manifest) == expected
        return True

    def of_one(number: int) -> st.SearchStrategy[bytes]:
        made = json_like if files[number].suffix == ".json" else damaged
        whole = made(files[number].read_bytes())
        return whole.map(lambda content: bytes([number]) + content)

    return [st.integers(0, len(files) - 1).flatmap(of_one)], attempt


SUBJECTS: dict[str, Subject] = {
    **{key: of_format(key) for key in FORMATS},
    "columns of text": columns_of("text"),
    "columns of ascii-trajectory": columns_of("ascii-trajectory"),
    "window settings": remembered,
    "project": project,
    "sightings": sightings,
    "coordinate list": coordinate_list,
    "static scan": static_scans,
    "store manifest": manifest,
    "store columns": columns,
    "store spool": spool,
}


def test_every_registered_format_has_sound_files(tmp_path: Path) -> None:
    """So that none is fuzzed with what it never reads."""
    for key in FORMATS:
        folder = tmp_path / key
        folder.mkdir()
        SUBJECTS[key](folder)
        files = [path for path in folder.iterdir() if path.name != "any"]
        assert files
        for path in files:
            choice = format_of(key).look(path, {}).choice
            assert said_by(lambda: read_wholly(key, path, choice)) is None  # noqa: B023


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", SUBJECTS)
def test_only_own_errors(tmp_path: Path, name: str) -> None:
    sources, attempt = SUBJECTS[name](tmp_path)
    for source in sources:
        fuzz(source, attempt, SHORT)


@pytest.mark.long
@pytest.mark.timeout(600)
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", SUBJECTS)
def test_only_own_errors_at_length(tmp_path: Path, name: str) -> None:
    """Each for a minute or 100,000 inputs; -s shows how many."""
    sources, attempt = SUBJECTS[name](tmp_path)
    assert fuzz_long(name, sources, attempt) >= 100
