"""Cases of bad input: units, places, folders, disks, and files that are removed or changed."""

import os
from collections.abc import Callable
from pathlib import Path

import laspy
import numpy as np

from lispac.cli.main import main
from lispac.io.las import las_chunks
from lispac.workflow.project.projects import open_project
from lispac.workflow.project.survey import load_survey
from tests.support.bad_files import COUNT, REFUSED, TIMES, Case, Scene, Words, refused, with_warning
from tests.support.input_file_samples import START, fan, write_line
from tests.support.trajectory_files import vessel, write_records

# Units, places and coordinate systems.


@refused("Degrees instead of radians")
def _(scene: Scene) -> Words:
    records = vessel(2000)
    angles = [1, 2, 7, 8, 9, 10]
    records[:, angles] = np.degrees(records[:, angles])
    write_records(scene / "pos.sbet", records)
    return scene.new("L1.las", "--trajectory-option", "unit=radians")


@with_warning("Degrees instead of radians, detected by lispac inspect")
def _(scene: Scene) -> Words:
    REFUSED["Degrees instead of radians"](scene)
    return scene.inspect("pos.sbet")


@with_warning("Feet instead of metres in a line")
def _(scene: Scene) -> Words:
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 0.0003048)
    data = laspy.LasData(header)
    data.x, data.y, data.z = fan(COUNT).T
    data.gps_time = TIMES
    data.write(scene / "L1.las")
    return scene.inspect("L1.las")


@with_warning("Millimetres instead of metres in a line")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES, fan(COUNT) * 1000 / 3)
    return scene.inspect("L1.las")


def exchanged(scene: Scene, north: float = 0.0) -> None:
    records = vessel(2000)
    records[:, [1, 2]] = records[:, [2, 1]]
    records[:, 1] -= np.radians(north)
    write_records(scene / "pos.sbet", records)


@refused("Exchanged latitude and longitude, latitude above 90 deg")
def _(scene: Scene) -> Words:
    exchanged(scene, 50)
    return scene.new("L1.las", "--trajectory-option", "order=latitude-longitude")


@with_warning("Exchanged latitude and longitude, both possible")
def _(scene: Scene) -> Words:
    exchanged(scene)
    return scene.inspect("pos.sbet")


@refused("Exchanged latitude and longitude in a text trajectory")
def _(scene: Scene) -> Words:
    rows = [f"{START + k / 10:.1f} -123.5 45.5 10 0 0 90" for k in range(300)]
    (scene / "nav.txt").write_text("\n".join(rows) + "\n")
    columns = "columns=time latitude longitude height roll pitch heading"
    return scene.new(
        "L1.las", "--trajectory-format", "ascii-trajectory", "--trajectory-option", columns,
        trajectory="nav.txt",
    )  # fmt: skip


@refused("Unknown coordinate system: none in the file")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES, fan(COUNT) + [617_200, 5_039_400, 0])
    return scene.new()


@refused("Unknown coordinate system: the code does not exist")
def _(scene: Scene) -> Words:
    scene.make_project()
    return scene.georeference("out", "--crs", "EPSG:999999")


@refused("Wrong coordinate system: points far from the trajectory")
def _(scene: Scene) -> Words:
    write_line(scene / "L1.las", TIMES, fan(COUNT) + [617_200, 5_039_400, 0], "EPSG:32619")
    return scene.new()


@with_warning("Wrong output coordinate system: intended for another part of the world")
def _(scene: Scene) -> Words:
    scene.make_project()
    return scene.georeference("out", "--crs", "EPSG:32633")


# Folders and disks.


@refused("Read-only folder: new project")
def _(scene: Scene) -> Words:
    scene.mount_disk("1m")
    scene.make_disk_read_only()
    return scene.new(to="disk/quay")


@refused("Read-only folder: import")
def _(scene: Scene) -> Words:
    scene.mount_disk("1m")
    scene.make_project(to="disk/quay")
    scene.make_disk_read_only()
    return ["import", str(scene / "disk/quay")]


@refused("Read-only folder: georeferenced cloud")
def _(scene: Scene) -> Words:
    scene.make_project()
    scene.mount_disk("1m")
    scene.make_disk_read_only()
    return scene.georeference("disk/out")


@refused("File with the name of the output folder")
def _(scene: Scene) -> Words:
    scene.make_project()
    return scene.georeference("L1.las/out")


@refused("Disk full: new project")
def _(scene: Scene) -> Words:
    scene.mount_disk("16k")
    scene.fill_disk()
    return scene.new(to="disk/quay")


@refused("Disk full: import")
def _(scene: Scene) -> Words:
    scene.mount_disk("4m")
    write_line(scene / "L1.las", START + np.linspace(2, 12, 600_000))
    scene.make_project(to="disk/quay")
    return ["import", str(scene / "disk/quay")]


@refused("Disk full: georeferenced cloud")
def _(scene: Scene) -> Words:
    scene.make_project()
    scene.mount_disk("32k")
    return scene.georeference("disk/out")


@refused("Disk full: exported trajectory")
def _(scene: Scene) -> Words:
    scene.mount_disk("32k")
    output = str(scene / "disk/track.sbet")
    return ["export", scene.make_project(), "--what", "trajectory", "--output", output]


# Files that are removed or changed.


def removed(name: str, command: Callable[[Scene, str], Words]) -> Case:
    def case(scene: Scene) -> Words:
        project = scene.make_project()
        (scene / name).unlink()
        return command(scene, project)

    return case


@refused("Output with the name of a survey file")
def _(scene: Scene) -> Words:
    project = scene.make_project()
    return ["export", project, "--what", "trajectory", "--output", str(scene / "L1.las")]


refused("File missing")(lambda scene: scene.new("L7.las"))
refused("File removed before the import")(removed("L1.las", lambda _, p: ["import", p]))
refused("File removed before georeferencing")(removed("L1.las", lambda s, _: s.georeference()))
refused("File removed before the estimate")(removed("L1.las", lambda _, p: ["estimate", p]))
refused("Trajectory removed before the import")(removed("pos.sbet", lambda _, p: ["import", p]))


def wall(scene: Scene, count: int = COUNT) -> Path:
    """Write a line that shows a wall 10 m to the left."""
    points = fan(count) * [1, 0, 1] + [0, 10, 0]
    return write_line(scene / "L1.las", TIMES[:count], points)


@refused("Line changed after a target was picked")
def _(scene: Scene) -> Words:
    wall(scene)
    project = scene.make_project()
    seed = load_survey(open_project(Path(project))).clouds["L1"].sample[COUNT // 2]
    assert main(["pick", project, "--name", "T1", "--seed", *(f"{v:.3f}" for v in seed)]) == 0
    wall(scene, COUNT - 1)
    return ["estimate", project]


def while_read(act: Callable[[Path], object], command: Callable[[Scene, str], Words]) -> Case:
    """A case that calls ``act`` on the line file after its first points have been read."""

    def case(scene: Scene) -> Words:
        project, sound = scene.make_project(), las_chunks.require_usable_points
        scene.changed_files.add("L1.las")

        def spoil(*arguments: object) -> None:
            sound(*arguments)  # type: ignore[arg-type]
            if (scene / "L1.las").exists():
                act(scene / "L1.las")

        scene.patch.setattr(las_chunks, "POINTS_PER_CHUNK", 200)
        scene.patch.setattr(las_chunks, "require_usable_points", spoil)
        return command(scene, project)

    return case


def shorten(path: Path) -> None:
    os.truncate(path, 40_000)


refused("File removed during the import")(while_read(Path.unlink, lambda _, p: ["import", p]))
refused("File cut short during the import")(while_read(shorten, lambda _, p: ["import", p]))
refused("File cut short during georeferencing")(while_read(shorten, lambda s, _: s.georeference()))


ACTIONS = {
    "Mixed time bases: line in time of day, trajectory in time of week": "--time-shift 432000",
    "Mixed time bases: trajectory in adjusted standard GPS time": "--time-shift 330560000",
    "Degrees instead of radians": "--trajectory-option unit=degrees",
    "Exchanged latitude and longitude, latitude above 90 deg": (
        "--trajectory-option order=longitude-latitude"
    ),
    "Unknown coordinate system: none in the file": "--line-option crs=EPSG:32618",
}
"""Options that correct the error according to the manual, by the name of the row."""
