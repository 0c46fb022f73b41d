"""Tests that readers raise only errors of the program on generated and damaged files."""

import json
import re
import shutil
import warnings
from argparse import Namespace
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pytest
from hypothesis import strategies as st

from lispac.cli.calibration.estimate import parse_parameters
from lispac.cli.parser import build_parser
from lispac.errors import Cancelled, LispacError
from lispac.gui.app.settings import AppSettings
from lispac.io.config.plan_file import read_plan, read_site
from lispac.io.config.scanner_file import read_scanner
from lispac.io.config.scene_file import read_scene
from lispac.io.config.sensor_file import read_pos_specification, read_scanner_specification
from lispac.io.config.vessel_file import read_vessel
from lispac.io.format_types import FilePreview
from lispac.io.formats import ACCURACY_FORMATS, POINT_FORMATS, TRAJECTORY_FORMATS, format_of
from lispac.io.point_reader_common import usable_points
from lispac.io.points.mesh_file import MeshReader, read_mesh
from lispac.io.points.static_scan import open_static_scan
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.io.text.seed_file import is_point_list, read_point_list
from lispac.simulation.meshes import Mesh
from lispac.survey.store import layout
from lispac.survey.store.column_files import file_checksum
from lispac.survey.store.line_import import write_store
from lispac.survey.store.stored_line import open_store
from lispac.targets.finder_settings import FinderChoices
from lispac.workflow.output.report_options import report_options
from tests.io.test_trajectory_bad_input import anything
from tests.simulation.test_meshes import write_mesh
from tests.support import point_files, trajectory_files
from tests.support.fuzzing import Attempt, damaged, fuzz, fuzz_long, json_like, toml_like
from tests.support.report_sample import sample_project
from tests.support.static_scans import write_pts
from tests.support.store_lines import RECIPE, Line, files_of, place, small, stop_at

__all__ = ["small"]

ROOT = Path(__file__).parents[2]
FORMATS = {
    format.key: format for format in (*TRAJECTORY_FORMATS, *ACCURACY_FORMATS, *POINT_FORMATS)
}
EXAMPLES_PER_SOURCE = 5

Sources = list[st.SearchStrategy[bytes]]
Subject = Callable[[Path], tuple[Sources, Attempt]]


def refusal_of(task: Callable[[], object]) -> str | None:
    """Error text of a refused task, or None if it succeeds; other errors are raised."""
    text = None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            task()
    except LispacError as refused:
        text = str(refused)
    assert text is None or "\n" not in text
    return text


def read_wholly(key: str, path: Path, choice: Any) -> None:
    """Read a file to its end and check that all values are finite.

    Readers of points may leave invalid points to the screening of a line.
    """
    result = FORMATS[key].read(path, choice)
    if FORMATS[key].kind != "points":
        arrays = [each for each in vars(result).values() if isinstance(each, np.ndarray)]
        assert len(arrays) >= 3
        assert all(np.isfinite(each).all() for each in arrays)
        return
    for chunk in map(usable_points, result):  # type: ignore[arg-type]
        assert np.isfinite(chunk.xyz).all()
        assert np.isfinite(chunk.time).all()


def of_format(key: str) -> Subject:
    def subject(folder: Path) -> tuple[Sources, Attempt]:
        if FORMATS[key].kind == "points":
            sound = [
                write(folder / name)
                for name, (format, write) in point_files.VALID_FILES.items()
                if format == key
            ]
        else:
            sound = [trajectory_files.VALID_FILES[key](folder / "sound")]
        path = folder / f"any{sound[0].suffix}"

        def attempt(content: bytes) -> bool:
            path.write_bytes(content)
            assert 0 <= FORMATS[key].sniff(path) <= 1
            findings: list[FilePreview] = []
            refusal_of(lambda: findings.append(FORMATS[key].preview(path, {})))
            refusals = [
                refusal_of(lambda choice=choice: read_wholly(key, path, choice))  # type: ignore[misc]
                for choice in ({}, *(finding.choice for finding in findings))
            ]
            assert not any(text for text in refusals if text and str(path) not in text)
            return None in refusals

        changed = [damaged(file.read_bytes()) for file in sound]
        extremes = [extreme(file.read_bytes()) for file in sound]
        return [*changed, *extremes, *changed, anything], attempt

    return subject


EXTREMES = [5e-324, 1e-320, -1e-320, 1e300, -1e308, 1e31, 2.0**63, np.nan, np.inf]


def extreme(content: bytes) -> st.SearchStrategy[bytes]:
    """Bytes of a file with long runs of digits in its text and extreme binary numbers."""
    digits = [found.span() for found in re.finditer(rb"[0-9]+", content[:4096])] or [(0, 0)]
    run = st.builds(
        lambda at, length, digit: content[: at[0]] + digit * length + content[at[1] :],
        st.sampled_from(digits),
        st.sampled_from([20, 400, 5000]),
        st.sampled_from([b"9", b"0", "\u0663".encode()]),
    )

    def with_numbers(first: int, step: int, value: float) -> bytes:
        changed = bytearray(content)
        for at in range(8 * first, len(changed) - 7, 8 * step):
            changed[at : at + 8] = np.float64(value).tobytes()
        return bytes(changed)

    def with_slow_times(columns: int, step: float) -> bytes:
        numbers = np.frombuffer(content[: len(content) // 8 * 8]).copy()
        rows = numbers[: len(numbers) // columns * columns].reshape(-1, columns)
        rows[:, 0] = np.arange(len(rows)) * step
        return numbers.tobytes()

    numbers = st.builds(
        with_numbers,
        st.integers(0, max(len(content) // 8, 1)),
        st.sampled_from([1, 4, 10, 17, 1 << 30]),
        st.sampled_from(EXTREMES),
    )
    times = st.builds(
        with_slow_times, st.sampled_from([4, 10, 17]), st.sampled_from([5e-324, 1e-320, 1e300])
    )
    return st.one_of(run, numbers, times)


TRAJECTORY_ROLES = ["time", "latitude", "longitude", "height", "roll", "pitch", "heading"]


def columns_of(key: str) -> Subject:
    """Column mappings of a valid file, as given by the user or the project file."""

    def subject(folder: Path) -> tuple[Sources, Attempt]:
        named = key == "text"
        path = (
            point_files.text(folder / "a.csv")
            if named
            else trajectory_files.VALID_FILES[key](folder / "a.txt")
        )
        roles = [
            "time", "date", "x", "y", "z", "latitude", "longitude", "easting", "height",
            "sea_height", "roll", "pitch", "heading", "sroll", "-", "", "intensity",
        ]  # fmt: skip
        whole = ["time", "x", "y", "z", "-"] if named else TRAJECTORY_ROLES
        words = st.one_of(
            st.lists(st.sampled_from(roles) | st.text(max_size=5), max_size=9),
            st.permutations(whole),
            st.lists(st.sampled_from(roles), max_size=2).map(lambda more: [*whole, *more]),
        )
        written = st.builds(str.join, st.sampled_from([" ", ",", ", "]), words) | st.text(
            max_size=30
        )

        def attempt(content: bytes) -> bool:
            choice = {"columns": content.decode("utf-8", "surrogatepass")}
            refusal_of(lambda: FORMATS[key].preview(path, choice))
            return refusal_of(lambda: read_wholly(key, path, choice)) is None

        return [written.map(lambda text: text.encode("utf-8", "surrogatepass"))], attempt

    return subject


def window_settings(folder: Path) -> tuple[Sources, Attempt]:
    """Stored settings of the window, including column mappings."""
    path = folder / "window.ini"
    sound = AppSettings(path)
    sound.save_column_mappings({"text/5/": "time x y z -", "ascii-trajectory/9/": "time roll"})
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
    path = folder / "p" / PROJECT_FILE_NAME

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return refusal_of(lambda: read_project(path)) is None

    return [json_like(path.read_bytes()), anything], attempt


def sightings(folder: Path) -> tuple[Sources, Attempt]:
    """Files of picked points beside a project file."""
    write_project(sample_project(folder / "p"))
    path = next((folder / "p" / "sightings").glob("*.npz"))

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return refusal_of(lambda: read_project(folder / "p")) is None

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
        is_point_list(path)
        refusals = [
            refusal_of(lambda local=local, columns=columns: read_point_list(  # type: ignore[misc]
                path, columns=columns, local=local, degrees=not local
            ))
            for local in (True, False)
            for columns in ((), ("name", "x", "y", "z"))
        ]  # fmt: skip
        assert all(str(path) in refusal for refusal in refusals if refusal)
        return None in refusals

    word = st.sampled_from(["T1", "V2", "1.5", "-2,5", "1e400", "x", "name", "#", '"', "", "t"])
    mark = st.sampled_from([",", ";", "\t", " ", "\n", "\r", ", "])
    made = st.lists(st.tuples(word, mark), max_size=40).map(
        lambda parts: "".join(text for pair in parts for text in pair).encode()
    )
    return [*(damaged(content) for content in sound), made, anything], attempt


def static_scans(folder: Path) -> tuple[Sources, Attempt]:
    """PTS files, which have no time and so are in no list of formats."""
    path = write_pts(folder / "scan.pts", [point_files.XYZ[:4], point_files.XYZ[4:9]])

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)

        def read() -> None:
            for chunk in open_static_scan(path).coordinate_chunks(local=True):
                assert np.isfinite(chunk).all()

        refusal = refusal_of(read)
        assert refusal is None or str(path) in refusal
        return refusal is None

    word = st.sampled_from(["1", "2", "0", "-7", "1.5", "1e400", "nan", "1_0", "1,5", "#", "x"])
    mark = st.sampled_from([" ", "\t", "\n", "\r\n", "\r"])
    made = st.lists(st.tuples(word, mark), max_size=40).map(
        lambda parts: "".join(text for pair in parts for text in pair).encode()
    )
    return [damaged(path.read_bytes()), made, anything], attempt


SMALL_LINE = Line(2_500)


def stored(folder: Path) -> None:
    write_store(folder, RECIPE, SMALL_LINE.pieces(200), place)


def read_store(folder: Path) -> None:
    """Open a store and read all of it."""
    found = open_store(folder, "L1")
    for points in (found.take(np.arange(0, len(found), 7))[0], found.coarse.points_local):
        assert (np.abs(points) < 1e6).all()
    for values in (found.points_lidar, found.time, *found.extra.values(), found.coarse.rows):
        np.asarray(values).tobytes()
    assert found.numbers(np.arange(3)).shape == (3,)
    with warnings.catch_warnings():
        # Only the checksum of the whole store detects changed numbers, so any may occur here.
        warnings.simplefilter("ignore", RuntimeWarning)
        found.within(np.zeros(3), 5.0, place)
    found.require_sound()


def manifest(folder: Path) -> tuple[Sources, Attempt]:
    """Manifests that are damaged, or changed with a correct checksum."""
    stored(folder / "L1")
    path = folder / "L1" / layout.MANIFEST_FILE

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return refusal_of(lambda: read_store(folder / "L1")) is None

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
    """Damaged column files of the right size; a wrong size is detected immediately."""
    stored(folder / "L1")
    paths = sorted((folder / "L1").glob("columns-*/*.npy"))
    sound = [path.read_bytes() for path in paths]

    def attempt(content: bytes) -> bool:
        number, content = content[0] % len(paths), content[1:]
        whole = sound[number]
        paths[number].write_bytes((content + whole[len(content) :])[: len(whole)])
        try:
            return refusal_of(lambda: read_store(folder / "L1")) is None
        finally:
            paths[number].write_bytes(whole)

    def of_one(number: int) -> st.SearchStrategy[bytes]:
        return damaged(sound[number]).map(lambda content: bytes([number]) + content)

    numbers = st.integers(0, len(paths) - 1)
    any_of_them = st.builds(lambda k, made: bytes([k]) + made, numbers, anything)
    return [numbers.flatmap(of_one), any_of_them], attempt


def resealed_columns(folder: Path) -> tuple[Sources, Attempt]:
    """Column files that are changed with correct checksums and times."""
    stored(folder / "L1")
    whole = layout.read_manifest(folder / "L1")
    assert whole is not None
    paths = [folder / "L1" / whole.folder / column.file for column in whole.files]
    sound = [path.read_bytes() for path in paths]

    def attempt(content: bytes) -> bool:
        number, content = content[0] % len(paths), content[1:]
        paths[number].write_bytes((content + sound[number][len(content) :])[: len(sound[number])])
        reseal(folder / "L1", whole)
        try:
            return refusal_of(lambda: read_store(folder / "L1")) is None
        finally:
            paths[number].write_bytes(sound[number])

    extreme = st.sampled_from([np.nan, np.inf, -np.inf, 3e38, -1.0, 1e300, 2.0**31, 2.0**63 - 1024])

    def with_value(number: int) -> st.SearchStrategy[bytes]:
        values = np.load(paths[number])

        def changed(at: int, value: float) -> bytes:
            made = values.copy()
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore", RuntimeWarning)
                made.flat[at % made.size] = np.array(value).astype(made.dtype)
            buffer = BytesIO()
            np.save(buffer, made)
            return bytes([number]) + buffer.getvalue()

        return st.builds(changed, st.integers(0, values.size), extreme)

    def of_one(number: int) -> st.SearchStrategy[bytes]:
        return damaged(sound[number]).map(lambda content: bytes([number]) + content)

    numbers = st.integers(0, len(paths) - 1)
    return [numbers.flatmap(with_value), numbers.flatmap(of_one)], attempt


def reseal(folder: Path, manifest: layout.Manifest) -> None:
    """Update the checksums and times of the column files in the manifest."""

    def sealed(column: layout.StoredColumn) -> layout.StoredColumn:
        if not column.file:
            return column
        path = folder / manifest.folder / column.file
        status = path.stat()
        return replace(
            column, checksum=file_checksum(path), size=status.st_size, modified=status.st_mtime_ns
        )

    layout.write_manifest(
        folder,
        replace(
            manifest,
            columns=tuple(sealed(column) for column in manifest.columns),
            attributes=tuple(sealed(column) for column in manifest.attributes),
        ),
    )


def spool(folder: Path) -> tuple[Sources, Attempt]:
    """Files of an interrupted import: used if complete, otherwise read again."""
    stored(folder / "whole")
    expected = files_of(open_store(folder / "whole", "L1").manifest)
    with pytest.raises(Cancelled):
        write_store(folder / "half", RECIPE, SMALL_LINE.pieces(200), place, progress=stop_at(15))
    files = sorted((folder / "half" / layout.SPOOL_FOLDER).iterdir())
    assert {"block-00002.json", "complete.json", "recipe.json"} <= {file.name for file in files}

    def attempt(content: bytes) -> bool:
        shutil.rmtree(folder / "L1", ignore_errors=True)
        shutil.copytree(folder / "half", folder / "L1")
        (folder / "L1" / layout.SPOOL_FOLDER / files[content[0] % len(files)].name).write_bytes(
            content[1:]
        )
        text = refusal_of(lambda: stored(folder / "L1"))
        assert text is None
        assert files_of(open_store(folder / "L1", "L1").manifest) == expected
        return True

    def of_one(number: int) -> st.SearchStrategy[bytes]:
        made = json_like if files[number].suffix == ".json" else damaged
        whole = made(files[number].read_bytes())
        return whole.map(lambda content: bytes([number]) + content)

    return [st.integers(0, len(files) - 1).flatmap(of_one)], attempt


def toml(pattern: str, read: Callable[[Path], object]) -> Subject:
    """TOML files of the program that match a pattern, and a reader of such files."""

    def made(folder: Path) -> tuple[Sources, Attempt]:
        path = folder / "made.toml"
        sources = sorted(ROOT.glob(pattern))
        assert sources

        def attempt(content: bytes) -> bool:
            path.write_bytes(content)
            text = refusal_of(lambda: read(path))
            assert text is None or len(text) < 1500
            return text is None

        return [*(toml_like(source.read_bytes()) for source in sources), anything], attempt

    return made


def report_template(folder: Path) -> tuple[Sources, Attempt]:
    path = folder / "made.toml"
    sound = (
        b'company = "Lev\xc3\xa9s"\nheading = "Quai"\nlogo = "logo.png"\npage = "A4"\n'
        b'language = "fr"\n'
    )

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return refusal_of(lambda: report_options(path)) is None

    return [toml_like(sound), anything], attempt


def meshes(folder: Path) -> tuple[Sources, Attempt]:
    """Meshes, read in one process that is restarted if a file ends it."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]], dtype=float)
    mesh = Mesh("m", corners, np.array([[0, 1, 2], [0, 2, 3]]))
    sources = []
    for name in ("a.ply", "a.stl", "a.obj"):
        write_mesh(folder / name, mesh)
        sources.append((folder / name).read_bytes())
    sources.append(
        b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    )
    path = folder / "mesh.ply"
    count = st.integers(0, 2**64).map(lambda n: sources[-1].replace(b"vertex 3", b"vertex %d" % n))
    faces = st.integers(0, 2**64).map(lambda n: sources[0].replace(b"face 2", b"face %d" % n))
    reader = MeshReader()

    def attempt(content: bytes) -> bool:
        path.write_bytes(content)
        return refusal_of(lambda: read_mesh(path, "m", 0.4, reader=reader)) is None

    runs = [extreme(source) for source in sources]
    return [*(damaged(source) for source in sources), *runs, count, faces, anything], attempt


def option_values(folder: Path) -> tuple[Sources, Attempt]:
    """Options of the command line with extreme numbers, which a project then stores."""
    project = sample_project(folder / "p")
    write_project(project)
    value = st.sampled_from([repr(each) for each in EXTREMES]) | st.floats().map(repr)
    options = {
        "pick": ("--threshold", "--radius", "--max-tilt", "--stop", "--sphere-radius"),
        "estimate": (
            "--estimate=range-offset=", "--estimate=latency=", "--lidar-sigma", "--subsample",
            "--latency", "--range-offset", "--position-time", "--surface",
        ),
    }  # fmt: skip
    words = st.one_of(
        *(
            st.tuples(st.just(command), st.sampled_from(names), value)
            for command, names in options.items()
        )
    )

    def attempt(content: bytes) -> bool:
        command, option, number = json.loads(content)
        arguments_of_option = (
            [f"{option}{number}"] if option.endswith("=") else [f"{option}={number}"]
        )
        place = ["--seed", "0", "0", "0", "--name", "T1"] if command == "pick" else []
        with suppress(SystemExit):
            arguments = build_parser().parse_args(
                [command, str(project.folder), *place, *arguments_of_option]
            )
            return refusal_of(lambda: keep(arguments)) is None
        return False

    def keep(arguments: Namespace) -> None:
        changed = project
        if arguments.command == "pick":
            target = project.targets[0]
            changed = replace(project, targets=(
                replace(
                    target,
                    threshold=arguments.threshold or target.threshold,
                    radius=arguments.radius or target.radius,
                ),
            ))  # fmt: skip
        else:
            parameters = parse_parameters(arguments.estimate) or ()
            changed = project.with_settings(replace(project.settings, parameters=parameters))
        write_project(changed)
        read_project(project.folder)

    return [words.map(lambda each: json.dumps(each).encode())], attempt


SUBJECTS: dict[str, Subject] = {
    "option values": option_values,
    "meshes": meshes,
    "scenes": toml("resources/scenes/*.toml", read_scene),
    "plans": toml("tests/data/*plan*.toml", read_plan),
    "sites": toml("resources/sites/*.toml", read_site),
    "scanners": toml("resources/scanners/*.toml", read_scanner),
    "scanner figures": toml(
        "resources/scanners/*.toml", partial(read_scanner_specification, whole=False)
    ),
    "POS figures": toml("resources/pos/*.toml", read_pos_specification),
    "vessels": toml("resources/vessels/*.toml", read_vessel),
    "report template": report_template,
    **{key: of_format(key) for key in FORMATS},
    "columns of text": columns_of("text"),
    "columns of ascii-trajectory": columns_of("ascii-trajectory"),
    "window settings": window_settings,
    "project": project,
    "sightings": sightings,
    "coordinate list": coordinate_list,
    "static scan": static_scans,
    "store manifest": manifest,
    "store columns": columns,
    "resealed store columns": resealed_columns,
    "store spool": spool,
}


def test_every_registered_format_has_valid_files(tmp_path: Path) -> None:
    """Every format is tested with files that its reader accepts."""
    for key in FORMATS:
        folder = tmp_path / key
        folder.mkdir()
        SUBJECTS[key](folder)
        files = [path for path in folder.iterdir() if path.name != "any"]
        assert files
        for path in files:
            choice = format_of(key).preview(path, {}).choice
            assert refusal_of(lambda: read_wholly(key, path, choice)) is None  # noqa: B023


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", SUBJECTS)
def test_readers_raise_only_own_errors(tmp_path: Path, name: str) -> None:
    sources, attempt = SUBJECTS[name](tmp_path)
    for source in sources:
        fuzz(source, attempt, EXAMPLES_PER_SOURCE)


@pytest.mark.long
@pytest.mark.timeout(600)
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("name", SUBJECTS)
def test_readers_raise_only_own_errors_in_long_runs(tmp_path: Path, name: str) -> None:
    """Each reader for a minute or 100,000 inputs; -s prints the number."""
    sources, attempt = SUBJECTS[name](tmp_path)
    assert fuzz_long(name, sources, attempt) >= 2_500
