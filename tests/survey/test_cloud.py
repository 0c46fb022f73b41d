"""Tests that lines on disk and lines in memory give the same results."""

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.errors import Cancelled, InputError
from lispac.io.las.las_format import write_points
from lispac.io.project.project_file import read_project, write_project
from lispac.messages import note
from lispac.progress import Step, no_progress
from lispac.project import LineSource, Project
from lispac.survey import cloud as cloud_module
from lispac.survey.cloud import CloudInMemory, CloudOnDisk
from lispac.survey.store import stored_line as reading_module
from lispac.workflow.calibration import target_search as seeking_module
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.target_search import thinned_notes
from lispac.workflow.checking.validation import validate
from lispac.workflow.importing.line_import import import_lines, line_folder
from lispac.workflow.output.data_export import export_targets
from lispac.workflow.output.export import report_content_of
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project import survey as survey_module
from lispac.workflow.project.projects import create_project, new_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.long_runs import LONG


def copied(lines: Sequence[LineSource], folder: Path) -> tuple[LineSource, ...]:
    """Lines with copies of their files, which a test may move while others read the originals."""
    return tuple(replace(line, path=Path(shutil.copy(line.path, folder))) for line in lines)


@pytest.fixture(scope="module")
def calibrated(denser_calibrated: tuple[Project, Survey]) -> tuple[Project, Survey]:
    """A survey with many points a line."""
    return denser_calibrated


@pytest.fixture(scope="module")
def project(
    calibrated: tuple[Project, Survey], tmp_path_factory: pytest.TempPathFactory
) -> Project:
    """Another copy of the built-in survey with its targets; all lines are imported."""
    source, folder = calibrated[0], tmp_path_factory.mktemp("disk")
    created = create_project(
        folder / "project", trajectory=source.trajectory, lines=copied(source.lines, folder),
        accuracy=source.accuracy, settings=source.settings,
    )  # fmt: skip
    import_lines(created)
    return replace(created, targets=source.targets)


@pytest.fixture(scope="module")
def stored(project: Project) -> Survey:
    """Survey of the imported lines, opened from the store."""
    return load_survey(project)


@LONG
def test_imported_lines_are_opened_from_the_store(project: Project, stored: Survey) -> None:
    assert all(isinstance(cloud, CloudOnDisk) for cloud in stored.clouds.values())
    # A missing source file does not matter, but gives a note.
    line = project.lines[0]
    moved = line.path.with_suffix(".moved")
    line.path.rename(moved)
    try:
        without = load_survey(project)
        assert without.lines == stored.lines
        assert note("import.file_gone", file=str(line.path), line=line.name) in without.notes
        elsewhere = replace(line, path=line.path.with_name("another.laz"))
        renamed = replace(project, lines=(elsewhere, *project.lines[1:]))
        with pytest.raises(InputError, match=r"another\.laz"):
            load_survey(renamed)
    finally:
        moved.rename(line.path)


@pytest.mark.parametrize("turned", [False, True])
def test_regions_and_points_on_disk_and_in_memory_agree(
    calibrated: tuple[Project, Survey], stored: Survey, turned: bool
) -> None:
    project, memory = calibrated
    prior = project.mounting("prior")
    mounting = prior.with_boresight(prior.boresight + [0.02, -0.03, 0.01]) if turned else prior
    for name in memory.lines[:2]:
        own = memory.clouds[name].georeferenced_with(mounting)
        other = stored.clouds[name].georeferenced_with(mounting)
        assert isinstance(own, CloudInMemory)
        np.testing.assert_allclose(own[np.array([5, 3])], other[np.array([5, 3])], atol=2e-5)
        for k in (2_000, 100_000):
            centre = own[np.array([k])][0] + 0.2
            region, beside = own.within(centre, 1.5), other.within(centre, 1.5)
            numbers, points = region.numbers, region.points
            found, placed = beside.numbers, beside.points
            assert region.one_in == beside.one_in == 1
            assert (np.diff(found) > 0).all()
            # Points within the rounding of stored coordinates from the sphere may be in or out.
            away = np.linalg.norm(points - centre, axis=1)
            assert np.isin(numbers[away < 1.5 - 2e-5], found).all()
            assert len(np.setdiff1d(found, own.within(centre, 1.5 + 2e-5).numbers)) == 0
            np.testing.assert_allclose(placed, other[found], rtol=0, atol=1e-9)
            assert len(numbers) > 20
        sample = other.sample
        assert len(sample) == len(other.sample_time)
        assert len(own.within(sample[7], 1e-3).numbers), "what is shown are points of the line"


def test_a_crowded_region_is_sampled_evenly(
    calibrated: tuple[Project, Survey], stored: Survey, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = stored.lines[0]
    centre = calibrated[1].clouds[name].sample[50_000]
    whole = stored.clouds[name].within(centre, 3.0)
    monkeypatch.setattr(cloud_module, "MAX_REGION_POINTS", len(whole.numbers) // 3)
    monkeypatch.setattr(reading_module, "PLACED_POINTS_PER_STEP", 1000)
    regions = [cloud.clouds[name].within(centre, 3.0) for cloud in (stored, calibrated[1])]
    for some in regions:
        assert some.one_in == 4
        assert len(some.numbers) == pytest.approx(len(whole.numbers) / 4, rel=0.1)
        assert np.isin(some.numbers, whole.numbers).all()
        for of in (np.mean, np.std):
            np.testing.assert_allclose(of(some.points, axis=0), of(whole.points, axis=0), atol=0.1)
    # On disk coordinates have 32 bits, so a point on the sphere may be in or out.
    apart = np.setxor1d(regions[0].numbers, regions[1].numbers)
    assert len(apart) <= 2


def test_a_thinned_sighting_has_a_note_and_stores_its_factor(
    calibrated: tuple[Project, Survey], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    project, survey = calibrated
    role, seed = demo_seeds()["T1"]
    assert thinned_notes(find_target(project, survey, seed, name="T1", role=role)) == ()
    monkeypatch.setattr(cloud_module, "MAX_REGION_POINTS", 500)
    monkeypatch.setattr(seeking_module, "MAX_SAMPLE_POINTS", 2000)
    target = find_target(project, survey, seed, name="T1", role=role)
    notes = thinned_notes(target)
    thinned = [s for s in target.sightings if s.one_in > 1]
    assert notes
    assert [(each.params["line"], each.params["one_in"]) for each in notes] == [
        (sighting.line, sighting.one_in) for sighting in thinned
    ]
    saved = replace(project, folder=tmp_path / "saved").with_target(target)
    write_project(saved)
    again = read_project(saved.folder).target("T1")
    assert [s.one_in for s in again.sightings] == [s.one_in for s in target.sightings]


@LONG
def test_one_seed_finds_the_same_points(
    calibrated: tuple[Project, Survey], project: Project, stored: Survey
) -> None:
    for name in ("T1", "V1"):
        role, seed = demo_seeds()[name]
        own = find_target(calibrated[0], calibrated[1], seed, name=name, role=role)
        other = find_target(project, stored, seed, name=name, role=role)
        assert [s.line for s in own.sightings] == [s.line for s in other.sightings]
        for one, two in zip(own.sightings, other.sightings, strict=True):
            assert one.fingerprint == two.fingerprint
            shared = len(np.intersect1d(one.indices, two.indices))
            assert shared > 0.995 * max(len(one.indices), len(two.indices))


def test_boresight_validation_and_exports_agree(
    calibrated: tuple[Project, Survey], project: Project, stored: Survey, tmp_path: Path
) -> None:
    own = calibrated[0].result
    assert own is not None
    solved = estimate(project, stored, cross_check=False)
    assert solved.result is not None
    assert np.abs(solved.result.boresight - own.boresight).max() < 0.1 * own.sigma.min()
    validated = validate(solved, stored)
    before = {c.name: c for c in calibrated[0].validation or validate(*calibrated).validation}
    for comparison in validated.validation:
        assert comparison.after.rms == pytest.approx(before[comparison.name].after.rms, rel=0.02)
    assert len(export_targets(solved, stored, tmp_path)) == len(solved.targets)
    assert report_content_of(validated, stored).warnings is not None


@LONG
def test_a_large_line_is_imported_when_the_project_is_opened(
    calibrated: tuple[Project, Survey], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = calibrated[0]
    project = create_project(
        tmp_path / "p", trajectory=source.trajectory, lines=copied(source.lines[:2], tmp_path),
        settings=source.settings,
    )  # fmt: skip
    assert isinstance(load_survey(project).clouds[project.lines[0].name], CloudInMemory)
    counts = [len(calibrated[1].scans[line.name]) for line in project.lines]
    monkeypatch.setattr(survey_module, "MAX_POINTS_IN_MEMORY", max(counts) - 1)
    opened = load_survey(project)
    kinds = {name: type(cloud) for name, cloud in opened.clouds.items()}
    assert CloudOnDisk in kinds.values()
    # An imported line stays on disk; a change of its import settings imports it again.
    monkeypatch.setattr(survey_module, "MAX_POINTS_IN_MEMORY", 10**12)
    assert {n: type(c) for n, c in load_survey(project).clouds.items()} == kinds
    name = next(name for name, kind in kinds.items() if kind is CloudOnDisk)
    other = replace(project, settings=replace(project.settings, longest_gap=0.7))
    assert isinstance(load_survey(other).clouds[name], CloudOnDisk)
    line = next(line for line in project.lines if line.name == name)
    moved = line.path.with_suffix(".moved")
    line.path.rename(moved)
    try:
        with pytest.raises(InputError, match=line.path.name):
            load_survey(project)
    finally:
        moved.rename(line.path)
    assert line_folder(project, line).is_dir()


def test_a_cancelled_new_project_of_large_lines_leaves_no_folder(
    calibrated: tuple[Project, Survey], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source, folder = calibrated[0], tmp_path / "p"
    monkeypatch.setattr(survey_module, "MAX_POINTS_IN_MEMORY", 0)

    def stop_on_second(fraction: float, step: Step | None = None) -> None:
        if str(step).startswith(f"Reading {source.lines[1].name}"):
            raise Cancelled

    def make(progress=no_progress) -> tuple[Project, Survey]:
        return new_project(
            folder, trajectory=source.trajectory, lines=source.lines[:2],
            settings=source.settings, progress=progress,
        )  # fmt: skip

    with pytest.raises(Cancelled):
        make(stop_on_second)
    assert not folder.exists()
    made, survey = make()
    assert all(isinstance(cloud, CloudOnDisk) for cloud in survey.clouds.values())
    assert [item.seconds for item in import_lines(made)] == [0, 0]


def test_a_repaired_file_is_imported_again(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    source, path = calibrated[0], tmp_path / "own.las"
    scan = calibrated[1].scans[source.lines[0].name]
    points = np.array(scan.points_lidar)
    write_points(path, points, scan.time)
    project = create_project(
        tmp_path / "p", trajectory=source.trajectory, lines=[LineSource("own", path)],
        settings=source.settings,
    )  # fmt: skip
    import_lines(project)
    changed = np.arange(50_000, 51_000)
    points[changed] += [0.0, 0.0, 1.0]
    size = path.stat().st_size
    write_points(path, points, scan.time)
    assert path.stat().st_size == size
    found, _ = load_survey(project).scans["own"].take(changed)
    np.testing.assert_allclose(found, points[changed], atol=1e-3)


def test_a_foreign_folder_in_place_of_a_store_is_not_changed(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    source = calibrated[0]
    line = source.lines[0]
    project = create_project(
        tmp_path / "p", trajectory=source.trajectory, lines=[line], settings=source.settings
    )
    own = line_folder(project, line) / "raw.part"
    own.parent.mkdir(parents=True)
    own.write_text("mine")
    assert isinstance(load_survey(project).clouds[line.name], CloudInMemory)
    import_lines(project)
    assert isinstance(load_survey(project).clouds[line.name], CloudOnDisk)
    assert own.read_text() == "mine"
