"""Tests of the geometry of the targets of a survey, and of sections across its planes."""

from dataclasses import replace

import numpy as np

from lispac.project import Project
from lispac.workflow.output.surfaces import plane_sections, surface_geometries
from lispac.workflow.project.survey import Survey


def test_geometry_of_targets_is_near_their_seeds(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    geometries = surface_geometries(project, survey)
    assert set(geometries) == {each.name for each in project.targets}
    for target in project.targets:
        found = geometries[target.name]
        assert found.extent is not None
        assert found.normal is not None
        assert np.linalg.norm(found.centre - np.array(target.seed)) < target.radius
        assert np.all(found.extent <= 2.5 * target.radius)
        times = [survey.scans[each.line].first_time for each in target.sightings]
        vessel = survey.trajectory.at(np.array(times)).position.mean(axis=0)
        assert found.normal @ (vessel - found.centre) > 0.0


def test_sections_show_that_the_calibration_brings_the_lines_together(
    calibrated: tuple[Project, Survey],
) -> None:
    project, survey = calibrated
    geometries = surface_geometries(project, survey)
    sections = plane_sections(project, survey, geometries)
    assert [each.plane for each in sections] == [each.name for each in project.validation]
    for section in sections:
        spreads = []
        for state in ("before_m", "after_m"):
            parts = [np.array(getattr(line, state)) for line in section.lines]
            spreads.append(np.ptp([each[:, 1].mean() for each in parts if len(each)]))
        assert spreads[1] < spreads[0]
        assert spreads[1] < 0.03  # some standard deviations of the position of a line
    assert plane_sections(replace(project, result=None), survey, geometries) == ()


def test_a_target_without_points_has_no_geometry(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    first, *others = project.targets
    unused = tuple(replace(each, used=False) for each in first.sightings)
    bare = replace(project, targets=(replace(first, sightings=unused), *others))
    assert set(surface_geometries(bare, survey)) == {each.name for each in others}
