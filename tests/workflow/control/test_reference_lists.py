"""Tests of lists of points and scans used as a reference for a survey of a few lines."""

from pathlib import Path

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.messages import Message, note
from lispac.project import Project
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.control import references
from lispac.workflow.control.references import read_reference
from lispac.workflow.project.survey import Survey
from tests.support.few_lines import on_board, picked_and_estimated, site_of_few_lines


@pytest.fixture
def known() -> tuple[Project, Survey]:
    return picked_and_estimated()


def corners(path: Path, off: float = 0.0) -> Path:
    """Write five surveyed points on T2 (sigma 2 mm), the middle one `off` metres off the board."""
    normal = site_of_few_lines().scene["T2"].normal
    places = [on_board("T2", a, u) for a, u in ((-0.4, -0.4), (0.4, -0.4), (0.4, 0.4), (-0.4, 0.4))]
    places.append(on_board("T2", 0, 0) + off * normal)
    rows = [f"B{k},{x[0]:.5f},{x[1]:.5f},{x[2]:.5f},0.002,T2" for k, x in enumerate(places)]
    path.write_text("\n".join(["name,north,west,up,sigma,plane", *rows]) + "\n")
    return path


@pytest.mark.parametrize("off", [0.0, 0.02])
def test_a_surveyed_point_away_from_its_plane_is_reported(
    known: tuple[Project, Survey], tmp_path: Path, off: float
) -> None:
    """The point is the centre of five, so the fitted plane moves by a fifth of its offset."""
    found = read_reference(
        corners(tmp_path / "b.csv", off), *known, sigma=0.005, search_distance=1.0
    )
    notes = [each for each in found.notes if each.code.startswith("reference.")]
    if off:
        assert [(each.code, each.params["plane"]) for each in notes] == [
            ("reference.plane_off", "T2")
        ]
        assert notes[0].params["distance"] == pytest.approx(0.016, abs=5e-5)
        assert notes[0].params["sigma"] == 0.002
    else:
        assert notes == []
    (plane,) = found.planes
    assert abs(plane.plane.distances(on_board("T2", 0, 0)[None])[0]) == pytest.approx(
        off / 5, abs=2e-5
    )


def test_a_scan_with_too_many_points_is_sampled_evenly(
    known: tuple[Project, Survey], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(1)
    near = np.array([on_board("T1", a, u) for a, u in rng.uniform(-0.5, 0.5, (3000, 2))])
    far = near[:500] + [0.0, 0.0, 500.0]
    path = tmp_path / "scan.xyz"
    np.savetxt(path, np.concatenate([near, far]), fmt="%.4f")
    whole = read_reference(path, *known, sigma=0.0, search_distance=1.0)
    assert len(whole.surface) == 3000
    used = note("reference.points_used", file="scan.xyz", used=3000, total=3500, one_in=1)
    assert used in whole.notes
    monkeypatch.setattr(references, "MAX_SCAN_POINTS", 1000)
    some = read_reference(path, *known, sigma=0.0, search_distance=1.0)
    assert 600 < len(some.surface) <= 1000
    assert {*map(tuple, some.surface)} < {*map(tuple, whole.surface)}
    assert np.abs(some.surface.mean(axis=0) - whole.surface.mean(axis=0)).max() < 0.05
    last = some.notes[-1]
    assert isinstance(last, Message)
    assert (last.code, last.params["one_in"]) == ("reference.points_used_sample", 4)


def test_a_scan_away_from_the_lines_is_refused(
    known: tuple[Project, Survey], tmp_path: Path
) -> None:
    """The scan is near enough to be of this site, but the lines have no points there."""
    path = tmp_path / "scan.xyz"
    np.savetxt(path, on_board("T1", 0, 0) + [200.0, 0.0, 0.0] + np.eye(3)[np.arange(1200) % 3])
    with pytest.raises(InputError) as caught:
        read_reference(path, *known, sigma=0.0, search_distance=0.5)
    assert caught.value.code == "check.reference_elsewhere"
    assert str(path) in str(caught.value)


@pytest.mark.parametrize(
    ("how", "code"),
    [
        ({"sigma": -0.01}, "check.reference_sigma"),
        ({"sigma": np.inf}, "check.reference_sigma"),
        ({"sigma": np.nan}, "check.reference_sigma"),
        ({"search_distance": 0.0}, "check.search_distance"),
        ({"search_distance": 10.5}, "check.search_distance"),
    ],
)
def test_sigmas_and_search_distances_out_of_range_are_refused(
    known: tuple[Project, Survey], tmp_path: Path, how: dict[str, float], code: str
) -> None:
    with pytest.raises(InputError) as caught:
        check_absolute(*known, corners(tmp_path / "b.csv"), **how)
    assert caught.value.code == code
    assert str(caught.value)
