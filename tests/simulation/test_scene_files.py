"""Tests of scenes, vessels and scanners read from TOML files, and of errors in such files."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError, ProjectError
from lispac.installation_paths import resource_path
from lispac.io.config.scanner_file import read_scanner
from lispac.io.config.scene_file import read_scene
from lispac.io.config.vessel_file import read_vessel
from lispac.messages import note
from lispac.simulation.pos_error_models import (
    CombinedModel,
    GnssOutage,
    PosErrors,
    StepErrors,
    WhiteNoise,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, PosErrorModel
from lispac.simulation.scanner import Scanner
from lispac.simulation.scene import Cylinder, Rectangle, tilted_rectangle
from lispac.simulation.simulated_survey import (
    BORESIGHT_DEG,
    LEVER_ARM,
    POINTS_PER_SECOND,
    POS_HEIGHT,
    SimulatedSurvey,
    simulate_survey,
)
from lispac.simulation.vessel_motion import SMALL_VESSEL
from lispac.workflow.planning.simulate import _surveyor_settings, require_replaceable
from lispac.workflow.planning.simulated_setup import PART_KINDS, read_simulation, supplied_titles
from tests.simulation.test_meshes import as_mesh, write_mesh
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

SCENE = """
title = "A board"
vessel = "launch"
scanner = "profiler"
[origin]
latitude_deg = 46
longitude_deg = -71
height_m = 0
[pattern]
distance_m = 10
[[lines]]
heading_deg = 0
bearing_deg = 90
run_in_m = 5
run_out_m = 5
[[surfaces]]
kind = "board"
name = "T1"
role = "target"
centre_m = [0, -10, 5]
width_m = 1
height_m = 1
facing_deg = 270
"""
LINE = SCENE[SCENE.index("[[lines]]") : SCENE.index("[[surfaces]]")]
WHITE_NOISE = WhiteNoise((0.01, 0.01, 0.01), (0.001, 0.001, 0.001))
VESSEL = resource_path("vessels") / "launch.toml"
SCANNER = resource_path("scanners") / "profiler.toml"


def edited(folder: Path, text: str, old: str, new: str) -> Path:
    assert old in text, "the test changes nothing"
    path = folder / "edited.toml"
    path.write_text(text.replace(old, new, 1))
    return path


@pytest.mark.parametrize("kind", PART_KINDS)
def test_all_supplied_files_are_valid(kind: str) -> None:
    titles = supplied_titles(kind)
    assert len(titles) >= 3
    assert len(set(titles.values())) == len(titles)
    for name in titles:
        path = resource_path(f"{kind}s") / f"{name}.toml"
        {"scene": read_scene, "vessel": read_vessel, "scanner": read_scanner}[kind](path)
    for name in titles if kind == "scene" else ():
        assert len(read_simulation(name).setup.targets) >= 2


def test_the_port_scene_equals_the_built_in_survey(port: SimulatedSurvey) -> None:
    """Simulations from the files and from the code are identical to the last bit."""
    made = simulate_survey(read_simulation("port").setup, seed=2019)
    for ours, theirs in zip(made.scene.surfaces, port.scene.surfaces, strict=True):
        assert (ours.name, ours.reflectance) == (theirs.name, theirs.reflectance)
        assert isinstance(ours, Rectangle | Cylinder)
        np.testing.assert_array_equal(ours.row, theirs.row)
    for of_scene, built_in in (
        (made.trajectory, port.trajectory),
        *zip(made.lines, port.lines, strict=True),
    ):
        for name, values in vars(built_in).items():
            np.testing.assert_array_equal(getattr(of_scene, name), values, err_msg=name)
    for own, theirs in ((made.targets, port.targets), (made.validation, port.validation)):
        assert own.keys() == theirs.keys()
        for name in own:
            np.testing.assert_array_equal(own[name], theirs[name])
    assert made.origin == port.origin
    np.testing.assert_array_equal(made.mounting.values, port.mounting.values)


def test_the_launch_and_the_profiler_equal_those_of_the_built_in_survey() -> None:
    vessel = read_vessel(VESSEL)
    assert vessel.handling == SMALL_VESSEL
    assert vessel.pos == HYDROGRAPHIC_INS
    assert (vessel.lever_arm, vessel.pos_height) == (LEVER_ARM, POS_HEIGHT)
    assert vessel.errors.boresight_deg == BORESIGHT_DEG
    assert read_scanner(SCANNER)[1] == Scanner(POINTS_PER_SECOND)


def test_a_survey_of_several_days_is_refused(tmp_path: Path) -> None:
    """A million metres at 2.2 m/s are 126 hours; this is checked before the simulation."""
    path = edited(tmp_path, SCENE, "run_in_m = 5", "run_in_m = 1_000_000")
    with pytest.raises(InputError) as raised:
        read_simulation(str(path))
    assert raised.value.code == "simulate.too_long"
    assert raised.value.message is not None
    assert raised.value.message.params["duration"] == pytest.approx(126 * 3600, rel=0.01)
    assert raised.value.message.params["limit"] == 12 * 3600


def test_a_pos_may_have_several_errors() -> None:
    pos = read_vessel(resource_path("vessels") / "launch-outage.toml").pos
    assert isinstance(pos, CombinedModel)
    assert [type(part) for part in pos.parts] == [
        type(HYDROGRAPHIC_INS), WhiteNoise, GnssOutage, StepErrors,
    ]  # fmt: skip
    assert pos.parts[2] == GnssOutage(
        100.0, 60.0, (0.4, 0.4, 0.2), tuple(np.radians([0.005, 0.005, 0.01]))
    )


def test_scanners_have_the_beams_of_their_files() -> None:
    beams = {name: read_scanner(resource_path("scanners") / f"{name}.toml")[1] for name in (
        "velodyne-hdl-32e", "ouster-os1-128", "hesai-pandar-xt32", "zf-9012",
    )}  # fmt: skip
    assert [len(each.elevations) for each in beams.values()] == [32, 128, 32, 1]
    low, high = np.degrees([min(beams["velodyne-hdl-32e"].elevations),
                            max(beams["velodyne-hdl-32e"].elevations)])  # fmt: skip
    assert (low, high) == pytest.approx((-30.67, 10.67))
    assert np.diff(np.sort(np.degrees(beams["velodyne-hdl-32e"].elevations))) == pytest.approx(
        1.333, abs=0.01
    )


@LONG
def test_a_mesh_is_read_beside_its_scene_and_occludes_the_board(tmp_path: Path) -> None:
    write_mesh(
        tmp_path / "hut.stl", as_mesh(tilted_rectangle("hut", (0.0, -8.0, 5.0), 3.0, 3.0, 270, 0))
    )
    path = edited(
        tmp_path, SCENE, "[[surfaces]]",
        '[[surfaces]]\nkind = "mesh"\nname = "hut"\nfile = "hut.stl"\n[[surfaces]]',
    )  # fmt: skip
    scene = read_scene(path).scene
    assert scene.names == ("T1", "hut")
    _, labels, _ = scene.intersect(
        np.array([[0.0, 0.0, 5.0], [0.0, -9.0, 5.0]]), np.tile([0.1, -1.0, 0.02], (2, 1))
    )
    assert labels.tolist() == [1, 0]
    (tmp_path / "hut.stl").unlink()
    with pytest.raises(InputError, check=has_code("file.not_found", kind=note("file.kind_mesh"))):
        read_scene(path)


@pytest.mark.parametrize(
    ("old", "new", "code", "params"),
    [
        ("width_m = 1", "width = 1", "toml.wrong_key",
         {"key": "surfaces[1].width", "wanted": "width_m"}),
        ("facing_deg = 270", "facing_deg = 270\nelevation = 3", "toml.unknown_key_similar",
         {"key": "surfaces[1].elevation", "similar": "elevation_deg"}),
        ("width_m = 1", "width_m = -1", "toml.not_above",
         {"key": "surfaces[1].width_m", "value": "-1", "bound": "0"}),
        ("width_m = 1", 'width_m = "wide"', "toml.not_a_number", {"value": "'wide'"}),
        ("width_m = 1", "width_m = nan", "toml.not_finite", {"value": "nan"}),
        ("[0, -10, 5]", "[0, -10]", "toml.wrong_number_count", {"count": 3}),
        ('"board"', '"bord"', "toml.not_a_choice",
         {"choices": ("board", "wall", "box", "cylinder", "sphere", "mesh")}),
        ('role = "target"', 'role = "goal"', "toml.not_a_choice",
         {"choices": ("target", "validation")}),
        ('name = "T1"', "", "toml.missing_key", {"key": "surfaces[1].name"}),
        ("run_out_m = 5", "run_out_m = 5\nspeed = 3", "toml.unknown_key",
         {"key": "lines[1].speed"}),
        ("bearing_deg = 90", "bearing_deg = 180", "scene.bearing_along_heading",
         {"key": "lines[1].bearing_deg"}),
        ("distance_m = 10", "", "scene.no_distance", {"key": "pattern.distance_m"}),
        ("latitude_deg = 46", "latitude_deg = 460", "toml.above_maximum",
         {"key": "origin.latitude_deg", "value": "460", "most": "90"}),
        ("title =", "title", "toml.invalid", {}),
        ('kind = "board"', 'kind = "cylinder"\nradius_m = 0.1', "scene.role_of_kind",
         {"key": "surfaces[1].role", "kind": "cylinder"}),
        (
            'kind = "board"\nname = "T1"\nrole = "target"',
            'kind = "sphere"\nradius_m = 1\nname = "V1"\nrole = "validation"',
            "scene.validation_sphere", {"key": "surfaces[1].role"},
        ),
        ('scanner = "profiler"', 'scanner = "profiler"\ncolour = 1', "toml.unknown_key",
         {"key": "colour"}),
        (
            "[[surfaces]]", "[[surfaces]]\n" + SCENE.split("[[surfaces]]\n")[1] + "[[surfaces]]",
            "scene.name_twice", {"key": "surfaces[2].name", "name": "T1"},
        ),
        ('name = "T1"', 'name = "a/b"', "scene.target_name", {"key": "surfaces[1].name"}),
        (SCENE[SCENE.index("[[surfaces]]") :], "", "scene.no_surfaces", {"key": "surfaces"}),
        (LINE, "", "scene.no_lines", {"key": "lines"}),
        (
            LINE, LINE + '[[lines]]\nstart_s = 1\nstop_s = 2\nside = "port"\n',
            "scene.mixed_lines", {"key": "lines"},
        ),
        (
            "run_in_m = 5\nrun_out_m = 5", "run_in_m = 0.5\nrun_out_m = 0.4",
            "scene.line_too_short", {"key": "lines"},
        ),
        ('title = "A board"', "title = 3", "toml.not_text", {"key": "title", "value": "3"}),
        ('title = "A board"', 'title = " "', "toml.not_text", {"key": "title", "value": "' '"}),
    ],
)  # fmt: skip
def test_errors_in_a_scene_file_are_reported(
    old: str, new: str, code: str, params: dict[str, object], tmp_path: Path
) -> None:
    path = edited(tmp_path, SCENE, old, new)
    with pytest.raises(InputError) as caught:
        read_scene(path)
    assert caught.value.code == code
    assert caught.value.message.params.items() >= (params | {"file": str(path)}).items()
    assert str(caught.value).startswith(f"{path}: ")
    assert str(caught.value).count("\n") == 0


def test_a_number_instead_of_tables_is_refused(tmp_path: Path) -> None:
    head = SCENE[: SCENE.index("[origin]")]
    for text, code, key in (
        (f"{head}origin = 3\n" + SCENE[SCENE.index("[pattern]") :], "toml.not_a_table", "origin"),
        (f"{head}surfaces = 3\n" + SCENE[len(head) : SCENE.index("[[surfaces]]")],
         "toml.not_a_list_of_tables", "surfaces"),
        (f"{head}surfaces = [3]\n" + SCENE[len(head) : SCENE.index("[[surfaces]]")],
         "toml.not_a_list_of_tables", "surfaces"),
    ):  # fmt: skip
        path = edited(tmp_path, text, "title", "title")
        with pytest.raises(InputError) as caught:
            read_scene(path)
        assert caught.value.code == code
        assert caught.value.message.params["key"] == key


def test_a_ball_has_the_position_of_its_scene_file(tmp_path: Path) -> None:
    ball = 'kind = "sphere"\nname = "B1"\nrole = "target"\ncentre_m = [1, -10, 5]\nradius_m = 0.3'
    path = edited(tmp_path, SCENE, "[[surfaces]]", f"[[surfaces]]\n{ball}\n[[surfaces]]")
    read = read_scene(path)
    assert read.targets == ("B1", "T1")
    away, _, _ = read.scene.intersect(np.array([[1.0, 0.0, 5.0]]), np.array([[0.0, -1.0, 0.0]]))
    assert away == pytest.approx(9.7)


@pytest.mark.parametrize(
    ("old", "new", "code", "params"),
    [
        ('"gauss-markov"', '"brownian"', "toml.not_a_choice", {"value": "'brownian'"}),
        ("position_s = 300", "", "toml.missing_key", {"key": "pos[1].position_s"}),
        ("attitude_s = 600", "attitude_s = 0", "toml.not_above", {"key": "pos[1].attitude_s"}),
        ("speed_abeam_m_s = 0.6", "speed_abeam_m_s = 6", "toml.above_maximum", {"most": "2.2"}),
        ("[[pos]]", "[[gps]]", "vessel.no_pos_errors", {"key": "pos"}),
        (
            "boresight_deg =",
            "boresight =",
            "toml.unknown_key_similar",
            {"similar": "boresight_deg"},
        ),
    ],
)
def test_errors_in_a_vessel_file_are_reported(
    old: str, new: str, code: str, params: dict[str, str], tmp_path: Path
) -> None:
    with pytest.raises(InputError) as caught:
        read_vessel(edited(tmp_path, VESSEL.read_text(), old, new))
    assert caught.value.code == code
    assert caught.value.message.params.items() >= params.items()


@pytest.mark.parametrize(
    ("old", "new", "code", "params"),
    [
        ("window_deg = [-1, 67]", "window_deg = [67, -1]", "scanner.window", {"key": "window_deg"}),
        ('axis = "x"', 'axis = "y"', "toml.not_a_choice", {"choices": ("x", "z")}),
        ("divergence_mrad", "divergence_deg", "toml.wrong_key", {"wanted": "divergence_mrad"}),
        ("max_range_m = 90", "max_range_m = 90\nelevations_deg = []", "scanner.no_elevations", {}),
        ("title", "unverified = 1\ntitle", "toml.not_true_or_false", {"key": "unverified"}),
    ],
)
def test_errors_in_a_scanner_file_are_reported(
    old: str, new: str, code: str, params: dict[str, object], tmp_path: Path
) -> None:
    with pytest.raises(InputError) as caught:
        read_scanner(edited(tmp_path, SCANNER.read_text(), old, new))
    assert caught.value.code == code
    assert caught.value.message.params.items() >= params.items()


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (
            SCENE.replace(LINE, '[[lines]]\nstart_s = 10\nstop_s = 20\nside = "port"\n'),
            "simulate.no_trajectory",
        ),
        (
            SCENE.replace("[origin]\nlatitude_deg = 46\nlongitude_deg = -71\nheight_m = 0\n", ""),
            "simulate.no_origin",
        ),
    ],
)
def test_an_impossible_scene_is_refused(text: str, code: str, tmp_path: Path) -> None:
    path = edited(tmp_path, text, "title", "title")
    with pytest.raises(InputError) as caught:
        read_simulation(str(path))
    assert caught.value.code == code
    assert str(caught.value).startswith(f"{path}: ")


@pytest.mark.parametrize(
    ("pos", "times"),
    [
        (PosErrorModel((0.1, 0.1, 0.1), (0.1, 0.1, 0.1), 120.0, 240.0), (120.0, 240.0)),
        (WHITE_NOISE, (300.0, 600.0)),
        (
            CombinedModel((WHITE_NOISE, PosErrorModel((0.1,) * 3, (0.1,) * 3, 90.0, 80.0))),
            (90.0, 80.0),
        ),
        (CombinedModel((WHITE_NOISE, WHITE_NOISE)), (300.0, 600.0)),
    ],
)
def test_settings_of_the_project_have_the_simulated_correlation_times(
    pos: PosErrors, times: tuple[float, float], tmp_path: Path
) -> None:
    """The default correlation times are set if the errors are not correlated in time."""
    made = read_simulation(str(edited(tmp_path, SCENE, "title", "title")))
    settings = _surveyor_settings(replace(made, setup=replace(made.setup, pos=pos)))
    assert (settings.position_time, settings.attitude_time) == times
    assert settings.lever_arm == LEVER_ARM


def test_simulating_into_a_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("mine")
    with pytest.raises(ProjectError) as caught:
        require_replaceable(path, "simulated")
    assert caught.value.code == "simulate.folder_is_file"
    assert str(path) in str(caught.value)
