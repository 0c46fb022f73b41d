"""Small point files in every format, written without the writers of the program."""

import gzip
import struct
from collections.abc import Callable, Mapping
from pathlib import Path
from uuid import UUID

import laspy
import numpy as np
import open3d as o3d
from pyproj import CRS

from tests.support.velodyne_packets import write_resting

COUNT = 60
RNG = np.random.default_rng(3)
XYZ = RNG.normal(0, 10, (COUNT, 3)).round(4)
TIME = np.linspace(400_000, 400_001, COUNT).round(6)
RING = RNG.integers(0, 64, COUNT).astype(np.uint16)


def las(
    path: Path,
    point_format: int = 6,
    version: str = "1.4",
    *,
    crs: str = "",
    adjusted: bool = False,
) -> Path:
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales, header.offsets = np.full(3, 1e-4), np.zeros(3)
    if crs:
        header.add_crs(CRS(crs))
    kinds = laspy.header.GpsTimeType
    header.global_encoding.gps_time_type = kinds.STANDARD if adjusted else kinds.WEEK_TIME
    header.add_extra_dim(laspy.ExtraBytesParams("ring", "u2"))
    data = laspy.LasData(header)
    data.x, data.y, data.z = XYZ.T
    if "gps_time" in header.point_format.dimension_names:
        data.gps_time = TIME
    data["ring"] = RING
    data.intensity = RING * 3
    data.write(path)
    return path


def cloud(path: Path, *, text: bool = False, compressed: bool = False, time: bool = True) -> Path:
    """Write PLY or PCD with Open3D."""
    points = o3d.t.geometry.PointCloud()
    points.point.positions = o3d.core.Tensor(XYZ)
    if time:
        # Open3D writes six digits in text files
        points.point["time"] = o3d.core.Tensor((TIME - 400_000 if text else TIME)[:, None])
    points.point["ring"] = o3d.core.Tensor(RING[:, None])
    assert o3d.t.io.write_point_cloud(str(path), points, write_ascii=text, compressed=compressed)
    return path


def big_endian_ply(path: Path) -> Path:
    """Write PLY with an element before the vertices and the name of times of CloudCompare."""
    head = (
        "ply\nformat binary_big_endian 1.0\ncomment by hand\n"
        "element camera 2\nproperty double view\nproperty uchar flag\n"
        f"element vertex {COUNT}\nproperty float64 x\nproperty float64 y\nproperty float64 z\n"
        "property double scalar_GpsTime\nproperty ushort ring\nend_header\n"
    )
    rows = b"".join(
        struct.pack(">4dH", *xyz, t, ring) for xyz, t, ring in zip(XYZ, TIME, RING, strict=True)
    )
    path.write_bytes(head.encode() + bytes(18) + rows)
    return path


def padded_pcd(path: Path) -> Path:
    """Write PCD with padding, a field of three values, and points without return."""
    head = (
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z _ timestamp normal\nSIZE 8 8 8 1 8 4\n"
        f"TYPE F F F U F F\nCOUNT 1 1 1 4 1 3\nWIDTH {COUNT}\nHEIGHT 1\n"
        f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {COUNT}\nDATA binary\n"
    )
    nothing = (np.nan,) * 3
    rows = b"".join(
        struct.pack("<3d4xd3f", *(nothing if k % 10 == 9 else XYZ[k]), TIME[k], 0, 0, 1)
        for k in range(COUNT)
    )
    path.write_bytes(head.encode() + rows)
    return path


def text(path: Path, row: str = "{t:.6f},{x:.4f},{y:.4f},{z:.4f},{ring}", head: str = "") -> Path:
    rows = [head] if head else []
    rows += [
        row.format(t=t, x=p[0], y=p[1], z=p[2], ring=ring)
        for t, p, ring in zip(TIME, XYZ, RING, strict=True)
    ]
    data = ("\n".join(rows) + "\n").encode()
    path.write_bytes(gzip.compress(data) if path.suffix == ".gz" else data)
    return path


def cidco(path: Path) -> Path:
    rows = b""
    for k in range(COUNT):
        position = (100.0, -200.0, 3.0)
        place = tuple(p + d for p, d in zip(position, XYZ[k], strict=True))
        sigma, attitude = (0.01,) * 3, (0.01, 0.02, 1.2)
        rows += struct.pack(
            "<22d", *place, TIME[k], *XYZ[k], *sigma, *attitude, *sigma, *position, *sigma
        )
    path.write_bytes(rows)
    return path


def planes(path: Path) -> Path:
    rows = []
    for k in range(COUNT):
        values = (
            k, *XYZ[k], TIME[k], *XYZ[k], 0.01, 0.02, 1.2, *(1e-4,) * 3, 5, 6, 7, *(0.01,) * 3,
            0.6, 0.8, 0.0, -3.0, 1,
        )  # fmt: skip
        rows.append(" ".join(f"{value:.9f}" for value in values))
    path.write_text("\n".join(rows) + "\n")
    return path


def target(path: Path) -> Path:
    names = "line,time (s),north (m),west (m),up (m),x lidar (m),y lidar (m),z lidar (m),intensity"
    rows = [names]
    for k in range(COUNT):
        values = (TIME[k], *(XYZ[k] + 100), *XYZ[k], RING[k])
        rows.append(f"L{1 + k % 2}," + ",".join(f"{value:.9f}" for value in values))
    path.write_text("\n".join(rows) + "\n")
    return path


def e57(
    path: Path,
    *,
    start: float = 1.4e9,
    stamps: np.ndarray | None = None,
    scans: int = 2,
    quaternion: tuple[float, ...] = (1, 0, 0, 0),
    translation: tuple[float, ...] = (0, 0, 0),
    spherical: bool = False,
    single: bool = False,
    invalid: bool = False,
    timed: bool = True,
    system: str = "",
    count: int = COUNT,
    without: tuple[str, ...] = (),
    first_without: tuple[str, ...] = (),
    pose_parts: tuple[str, ...] | None = ("rotation", "translation"),
    none_valid_of: int = 0,
    more: Mapping[str, np.ndarray] | None = None,
) -> Path:
    """Write ``scans`` scans with libE57; time stamps count from ``start``.

    Fields ``without`` are left out, those ``first_without`` of the first scan alone; where points
    are marked as invalid, the first ``none_valid_of`` all are. ``more`` are other fields; whole
    numbers are states.
    """
    from pye57 import libe57

    stamps = TIME - 400_000 if stamps is None else stamps
    image = libe57.ImageFile(str(path), "w")
    image.extensionsAdd("", libe57.E57_V1_0_URI)
    root = image.root()

    def number(node: object, **values: float) -> None:
        for name, value in values.items():
            node.set(name, libe57.FloatNode(image, float(value)))

    for name, value in (
        ("formatName", "ASTM E57 3D Imaging Data File"),
        ("guid", str(UUID(int=1))),
        ("coordinateMetadata", system),
    ):
        root.set(name, libe57.StringNode(image, value))
    root.set("versionMajor", libe57.IntegerNode(image, libe57.E57_FORMAT_MAJOR))
    root.set("versionMinor", libe57.IntegerNode(image, libe57.E57_FORMAT_MINOR))
    data = libe57.VectorNode(image, True)
    root.set("data3D", data)
    for rows in np.array_split(np.arange(count), scans):
        absent = without if len(data) else (*without, *first_without)
        scan = libe57.StructureNode(image)
        scan.set("guid", libe57.StringNode(image, str(UUID(int=2 + len(data)))))
        if start:
            begin = libe57.StructureNode(image)
            number(begin, dateTimeValue=start)
            scan.set("acquisitionStart", begin)
        pose = libe57.StructureNode(image)
        turn, shift = libe57.StructureNode(image), libe57.StructureNode(image)
        number(turn, **dict(zip("wxyz", quaternion, strict=True)))
        number(shift, **dict(zip("xyz", translation, strict=True)))
        for part, node in (("rotation", turn), ("translation", shift)):
            if part in (pose_parts or ()):
                pose.set(part, node)
        if pose_parts is not None:
            scan.set("pose", pose)
        xyz = XYZ[rows]
        distance = np.linalg.norm(xyz, axis=1)
        columns = (
            {
                "sphericalRange": distance,
                "sphericalAzimuth": np.arctan2(xyz[:, 1], xyz[:, 0]),
                "sphericalElevation": np.arcsin(xyz[:, 2] / distance),
            }
            if spherical
            else {f"cartesian{axis}": xyz[:, k].copy() for k, axis in enumerate("XYZ")}
        )
        if timed:
            columns["timeStamp"] = stamps[rows].copy()
        columns = {name: column for name, column in columns.items() if name not in absent}
        prototype = libe57.StructureNode(image)
        for name in columns:
            short = single and name == "timeStamp"
            kind = libe57.E57_SINGLE if short else libe57.E57_DOUBLE
            prototype.set(name, libe57.FloatNode(image, 0.0, kind, -1e30, 1e30))
        if "rowIndex" not in absent:
            columns["rowIndex"] = RING[rows].astype(np.float64)
            prototype.set("rowIndex", libe57.IntegerNode(image, 0, 0, 100))
        if invalid:
            marked = (rows < none_valid_of) | (rows % 2 == 1)
            columns["cartesianInvalidState"] = marked.astype(np.float64)
            prototype.set("cartesianInvalidState", libe57.IntegerNode(image, 0, 0, 2))
        for name, column in (more or {}).items():
            columns[name] = column[rows].astype(np.float64)
            whole = column.dtype.kind == "i"
            prototype.set(
                name,
                libe57.IntegerNode(image, 0, 0, 2)
                if whole
                else libe57.FloatNode(image, 0.0, libe57.E57_DOUBLE, -1e30, 1e30),
            )
        codecs = libe57.VectorNode(image, True)
        points = libe57.CompressedVectorNode(image, prototype, codecs)
        scan.set("points", points)
        data.append(scan)
        buffers = libe57.VectorSourceDestBuffer()
        for name, column in columns.items():
            buffers.append(libe57.SourceDestBuffer(image, name, column, len(rows), True, True))
        writer = points.writer(buffers)
        writer.write(len(rows))
        writer.close()
    image.close()
    return path


CSV_HEAD = "time,x,y,z,ring"
VALID_FILES: dict[str, tuple[str, Callable[[Path], Path]]] = {
    "a.las": ("las", lambda path: las(path, 1, "1.2", crs="EPSG:32619")),
    "b.las": ("las", lambda path: las(path, 7, "1.4", crs="EPSG:32619")),
    "a.laz": ("las", lambda path: las(path, 3, "1.3")),
    "b.laz": ("las", las),
    "a.e57": ("e57", lambda path: e57(path, invalid=True)),
    "a.ply": ("ply", cloud),
    "b.ply": ("ply", lambda path: cloud(path, text=True)),
    "c.ply": ("ply", big_endian_ply),
    "a.pcd": ("pcd", cloud),
    "b.pcd": ("pcd", lambda path: cloud(path, text=True)),
    "c.pcd": ("pcd", lambda path: cloud(path, compressed=True)),
    "d.pcd": ("pcd", padded_pcd),
    "a.pcap": ("velodyne", write_resting),
    "a.csv": ("text", lambda path: text(path, head=CSV_HEAD)),
    "b.csv.gz": ("text", lambda path: text(path, head=CSV_HEAD)),
    "cidco": ("cidco", cidco),
    "plane.txt": ("planes", planes),
    "target.csv": ("target", target),
}
"""Key of the format and writer of each file, by the name of the file."""
