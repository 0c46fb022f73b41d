"""Tests that the header of a LAS file is stored at the import and used for exports."""

import uuid
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.cli.main import main
from lispac.messages import Message
from lispac.project import LineSource, Project
from lispac.survey.store.layout import HEADER_FILE
from lispac.survey.store.stored_line import StoredLine
from lispac.workflow.importing.line_import import import_lines, line_folder, stored_header
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.project_copy import save_project_as
from lispac.workflow.project.projects import create_project
from lispac.workflow.project.survey import Survey, load_survey
from tests.support.message_codes import codes

GUID = uuid.UUID("12345678-1234-5678-1234-567812345678")


@pytest.fixture
def project(calibrated: tuple[Project, Survey], tmp_path: Path) -> Project:
    """Return a project with one imported LAZ line that has extra records and extra bytes."""
    source, survey = calibrated
    name = survey.lines[0]
    numbers = np.arange(5000)
    points, times = survey.scans[name].take(numbers)
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    header.system_identifier, header.uuid = "SCANNER 5", GUID
    header.file_source_id = 41
    header.add_extra_dims(
        [
            laspy.ExtraBytesParams(
                "reflectance", "i2", "in decibels", scales=np.array([0.01]), offsets=np.array([5.0])
            )
        ]
    )
    header.vlrs.append(laspy.VLR("maker", 7, "laboratory", b"calibrated in May"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = times
    las.intensity = numbers % 4000
    las.reflectance = 5.0 + 0.01 * (numbers % 100)
    path = tmp_path / "raw" / "own.laz"
    path.parent.mkdir()
    las.write(path)
    made = create_project(
        tmp_path / "quay", trajectory=source.trajectory, lines=[LineSource("own", path)],
        settings=source.settings,
    )  # fmt: skip
    import_lines(made)
    return made


def written(project: Project, folder: Path) -> tuple[laspy.LasData, tuple[Message, ...]]:
    (done,) = georeference_project(project, folder, "prior", system="EPSG:32619")
    return laspy.read(done.path), done.notes


def test_an_export_without_the_file_has_the_same_records(project: Project, tmp_path: Path) -> None:
    with_file, _ = written(project, tmp_path / "one")
    path = project.lines[0].path
    path.rename(path.with_suffix(".moved"))
    without, notes = written(project, tmp_path / "two")
    assert "export.file_gone" in codes(notes)
    for name in ("system_identifier", "uuid", "file_source_id", "generating_software"):
        assert getattr(without.header, name) == getattr(with_file.header, name)
    assert without.header.uuid == GUID
    assert without.header.point_format == with_file.header.point_format
    records = [
        [
            (v.user_id, v.record_id, v.record_data_bytes())
            for v in cloud.header.vlrs
            if not isinstance(v, laspy.vlrs.known.ExtraBytesVlr)  # laspy adds minimum and maximum
        ]
        for cloud in (with_file, without)
    ]
    assert records[0] == records[1]
    assert ("maker", 7, b"calibrated in May") in records[1]
    order = [np.argsort(cloud.gps_time, kind="stable") for cloud in (with_file, without)]
    for name in ("intensity", "reflectance", "gps_time", "x", "y", "z"):
        one, two = np.asarray(with_file[name])[order[0]], np.asarray(without[name])[order[1]]
        np.testing.assert_allclose(one, two, atol=2e-4 if name in "xyz" else 0, err_msg=name)
    assert np.asarray(without.reflectance).max() == pytest.approx(5.99)

    # The header is copied with the project.
    moved, _ = save_project_as(project, load_survey(project), tmp_path / "office")
    third, _ = written(moved, tmp_path / "three")
    assert third.header.uuid == GUID


def test_a_damaged_or_missing_header_is_reported(
    project: Project, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project.lines[0].path.unlink()
    folder = line_folder(project, project.lines[0])
    (header,) = folder.glob(f"columns-*/{HEADER_FILE}")
    whole = header.read_bytes()
    for n, damaged in enumerate((whole[:100], whole[:400] + bytes(len(whole) - 400), b"")):
        header.write_bytes(damaged)
        cloud, notes = written(project, tmp_path / f"one{n}")
        assert len(cloud.points) == 5000
        assert "export.file_and_header_gone" in codes(notes)
        capsys.readouterr()
        assert main(["import", str(project.folder), "--check"]) == 0
        assert "header records stored with them are damaged" in capsys.readouterr().err
    header.unlink()
    assert "export.file_and_header_gone" in codes(written(project, tmp_path / "two")[1])


def test_a_text_line_has_no_stored_header(
    calibrated: tuple[Project, Survey], tmp_path: Path
) -> None:
    source, survey = calibrated
    points, times = survey.scans[survey.lines[0]].take(np.arange(100))
    path = tmp_path / "line.csv"
    np.savetxt(path, np.column_stack([times, points]), fmt="%.6f", delimiter=",")
    line = LineSource("line", path, ("time", "x", "y", "z"))
    made = replace(source, folder=tmp_path / "p", lines=(line,), targets=(), result=None)
    (imported,) = import_lines(made)
    assert isinstance(imported.stored, StoredLine)
    assert stored_header(imported.stored) is None
