"""Tests of plans and sites as TOML: round trip and errors."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.design.plan import Line, System
from lispac.design.plan_choices import thesis_plan
from lispac.design.prediction import predict
from lispac.design.site import Site, Wall
from lispac.errors import InputError
from lispac.io.config.plan_file import TitledPlan, read_plan, read_site, write_plan
from lispac.messages import note
from lispac.simulation.closed_form_survey import Ball, Board
from lispac.simulation.pos_errors import PosErrorModel
from tests.support.error_codes import has_code

SITES = Path(__file__).parents[2] / "resources" / "sites"
PLAN = """
facing_deg = 250
[[boards]]
name = "T1"
along_m = 2
up_m = 5
[[lines]]
heading_deg = 340
distance_m = 15
site_on = "starboard"
"""


@pytest.mark.parametrize("facing", [270.0, 33.0])
def test_plan_round_trip(tmp_path: Path, facing: float) -> None:
    wall = Wall((0.0, 0.0, 0.0), facing)
    plan = thesis_plan(Site(wall.middle, facing))
    targets = (
        *plan.targets,
        wall.board(
            "floor", 3.0, -1.0, 0.0, (2.0, 3.0), off=4.0, flatness=0.004, control_sigma=0.003
        ),
        wall.board('odd "name"', 1.0, 9.0, 120.0, (1.0, 0.5), facing_deg=300.0),
        Ball("S1", wall.local_point(5.0, 1.0, 2.0), 0.15, False, 0.001, 0.002),
    )
    system = System(
        plan.system.mounting,
        replace(plan.system.scanner, range_sigma=0.004, max_range=120.0),
        PosErrorModel((0.01, 0.02, 0.03), tuple(np.radians([0.01, 0.02, 0.03])), 100.0, 200.0),
        "independent",
    )
    plan = replace(plan.with_targets(targets), system=system, interval=77.0, flatness=0.001)
    plan = plan.with_lines((*plan.lines, Line(12.5, 20.25, False, 0.7)))
    write_plan(tmp_path / "plan.toml", TitledPlan("Quai n° 3", plan, wall))
    again = read_plan(tmp_path / "plan.toml")
    assert again.title == "Quai n° 3"
    assert again.wall == wall
    assert again.plan.lines == plan.lines
    for one, other in zip(again.plan.targets, plan.targets, strict=True):
        assert one.name == other.name
        assert one.centre == pytest.approx(other.centre, abs=1e-6)
        assert one.flatness == other.flatness
        assert one.control_sigma == other.control_sigma
        if isinstance(one, Board) and isinstance(other, Board):
            assert one.facing == pytest.approx(other.facing, abs=1e-6)
    assert predict(again.plan).sigma == pytest.approx(predict(plan).sigma, rel=1e-6)
    assert predict(again.plan).points.keys() == predict(plan).points.keys()


@pytest.mark.parametrize("path", sorted(SITES.glob("*.toml")), ids=lambda path: path.stem)
def test_bundled_sites_are_read(path: Path) -> None:
    title, site = read_site(path)
    assert title
    assert site.allowed_lines
    assert np.isfinite(predict(thesis_plan(site)).sigma).all()


@pytest.mark.parametrize(
    ("change", "code", "key"),
    [
        (("heading_deg = 340", "heading = 340"), "toml.wrong_key", "lines[1].heading"),
        (('"starboard"', '"left"'), "toml.not_a_choice", "lines[1].site_on"),
        (("up_m = 5", 'up_m = "5"'), "toml.not_a_number", "boards[1].up_m"),
        (("up_m = 5", ""), "toml.missing_key", "boards[1].up_m"),
        (("distance_m = 15", "distance_m = 0"), "toml.not_above", "lines[1].distance_m"),
        (("[[lines]]", "[[line]]"), "plan.no_lines", "lines"),
        (("facing_deg = 250", "facing_deg = "), "toml.invalid", None),
        (
            ("[[boards]]", "[[boards]]\nname = 'T1'\nalong_m=0\nup_m=1\n[[boards]]"),
            "plan.name_twice", "boards",
        ),
    ],
)  # fmt: skip
def test_an_invalid_plan_is_refused(
    tmp_path: Path, change: tuple[str, str], code: str, key: str | None
) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    assert read_plan(path).plan.targets[0].name == "T1"
    path.write_text(PLAN.replace(*change))
    with pytest.raises(InputError) as refusal:
        read_plan(path)
    assert "plan.toml" in str(refusal.value)
    assert refusal.value.code == code
    assert refusal.value.message.params.get("key") == key


def test_a_plan_without_lines_or_boards_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "plan.toml"
    boards, lines = PLAN.split("[[lines]]")
    for text, code in ((boards, "plan.no_lines"), ("[[lines]]" + lines, "plan.no_targets")):
        path.write_text(text)
        with pytest.raises(InputError) as refusal:
            read_plan(path)
        assert refusal.value.code == code
    with pytest.raises(InputError, check=has_code("file.not_found", kind=note("file.kind_plan"))):
        read_plan(tmp_path / "none.toml")


def test_a_site_with_unequal_sizes_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "site.toml"
    path.write_text("[board_choices]\nwidth_m = [1, 2]\n")
    with pytest.raises(InputError) as refusal:
        read_site(path)
    assert refusal.value.code == "plan.sizes_differ"
    assert refusal.value.message.params["widths"] == 2


def test_a_fractional_count_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "site.toml"
    path.write_text("[board_choices]\nboards = 2.7\n")
    with pytest.raises(InputError) as refusal:
        read_site(path)
    assert refusal.value.code == "plan.not_whole"
    assert refusal.value.message.params["value"] == "2.7"
