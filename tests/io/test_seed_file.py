"""Tests of lists of target coordinates in various notations, and of invalid lists."""

from pathlib import Path

import pytest

from lispac.errors import InputError
from lispac.io.text.seed_file import PointList, is_point_list, read_point_list
from tests.support.error_codes import has_code

THREE_SEEDS = [("T1", (12.5, -3.25, 1.0)), ("V1", (40.0, 18.5, 22.0)), ("T2", (15.9, -3.0, 1.1))]


def written(folder: Path, text: str, *, encoding: str = "utf-8") -> Path:
    path = folder / "targets.txt"
    path.write_bytes(text.encode(encoding))
    return path


def names_and_coordinates(found: PointList) -> list[tuple[str, tuple[float, float, float]]]:
    return [(point.name, point.coordinates) for point in found.points]


@pytest.mark.parametrize(
    "text",
    [
        "T1 12.5 -3.25 1.0\nV1 40 18.5 22\nT2 15.9 -3 1.1\n",
        "T1,12.5,-3.25,1.0\nV1,40,18.5,22\nT2,15.9,-3,1.1",
        "T1\t12,5\t-3,25\t1,0\r\nV1\t40\t18,5\t22\r\nT2\t15,9\t-3\t1,1\r\n",
        "T1;12,5;-3,25;1,0\nV1;40,0;18,5;22\n\n;;;\nT2;15,9;-3;1,1\n",
        "T1 12,5 -3,25 1,0\nV1 40,0 18,5 22,0\nT2 15,9 -3,0 1,1\n",
        "# boards of May\n# name x y z\nT1 12.5 -3.25 1.0  \n% a remark\nV1 40 18.5 22\n"
        "T2 15.9 -3 1.1",
        "Point;North [m];West [m];Up [m];Code\nT1;12.5;-3.25;1;BOARD\nV1;40;18.5;22;WALL\n"
        "T2;15.9;-3;1.1;\n",
        "up,west,north,name\n1,-3.25,12.5,T1\n22,18.5,40,V1\n1.1,-3,15.9,T2\n",
        '"Name","X","Y","Z"\n"T1","12.5","-3.25","1.0"\n"V1","40","18.5","22"\n'
        '"T2","15.9","-3","1.1"\n',
    ],
)
def test_lists_are_read_in_various_notations(tmp_path: Path, text: str) -> None:
    for encoding in ("utf-8", "utf-8-sig", "utf-16"):
        path = written(tmp_path, text, encoding=encoding)
        assert names_and_coordinates(read_point_list(path)) == THREE_SEEDS
        assert is_point_list(path)


def test_roles_are_read_and_unnamed_points_are_named(tmp_path: Path) -> None:
    found = read_point_list(written(tmp_path, "A 1 2 3 v\nB 4 5 6 T\nC 7 8 9\n"))
    assert [point.role for point in found.points] == ["validation", "target", None]
    found = read_point_list(written(tmp_path, "1.5 2 3\n4 5 6\n"))
    assert names_and_coordinates(found) == [("", (1.5, 2.0, 3.0)), ("", (4.0, 5.0, 6.0))]
    assert found.columns == ("x", "y", "z")
    assert not found.are_columns_given
    assert not is_point_list(found.path)
    found = read_point_list(written(tmp_path, "101 1.5 2 3\n102 4 5 6 note\n"))
    assert [point.name for point in found.points] == ["101", "102"]


def test_named_or_given_columns_decide_the_order(tmp_path: Path) -> None:
    text = "pt,northing,easting,elevation,description\n1,5041635.7,614119.5,8.1,board\n"
    on_map = (614119.5, 5041635.7, 8.1)
    found = read_point_list(written(tmp_path, text), local=False)
    assert names_and_coordinates(found) == [("1", on_map)]
    assert found.are_columns_given
    bare = written(tmp_path, text.split("\n")[1])
    with_columns = read_point_list(bare, columns=["name", "y", "x", "z"], local=False)
    assert names_and_coordinates(with_columns) == [("1", on_map)]
    words = read_point_list(bare, columns=["point", "northing", "easting", "h"], local=False)
    assert names_and_coordinates(words) == [("1", on_map)]
    # Given columns take precedence over those named in the file.
    path = written(tmp_path, text)
    again = read_point_list(path, columns=["-", "y", "x", "z", "name"], local=False)
    assert names_and_coordinates(again) == [("board", on_map)]


def test_degrees_minutes_and_seconds_are_read(tmp_path: Path) -> None:
    text = "name;latitude;longitude;h\nT1;45°31'08.04\"N;W073:32:20.4;-17.5\n"
    found = read_point_list(written(tmp_path, text), local=False, degrees=True)
    longitude, latitude, height = found.points[0].coordinates
    assert (latitude, height) == pytest.approx((45 + 31 / 60 + 8.04 / 3600, -17.5), abs=1e-12)
    assert longitude == pytest.approx(-(73 + 32 / 60 + 20.4 / 3600), abs=1e-12)


@pytest.mark.parametrize(
    ("text", "row", "code", "params"),
    [
        ("", "", "text.empty", {}),
        ("# nothing\n\n", "", "seeds.no_coordinates", {}),
        ("name x y z\n", "", "seeds.only_names", {}),
        ("T1 1 2\n", "row 1", "seeds.too_few_numbers", {"found": 2, "total": 3}),
        ("T1 1 2 3 4\n", "row 1", "seeds.order_unclear", {"found": 4, "total": 5}),
        ("T1,12,5,3,25,1,0\n", "row 1", "seeds.order_unclear", {"found": 6, "total": 7}),
        ("T1 1 2 3\nT2 1 2\n", "row 2", "seeds.row_too_short", {"found": 3, "needed": 4}),
        ("T1 1 2 3\n\nT2 1 two 3\n", "row 3", "seeds.unusable_coordinate",
         {"axis": "y", "value": "two"}),
        ("T1 1 2 3\nT2 1 nan 3\n", "row 2", "seeds.unusable_coordinate",
         {"axis": "y", "value": "nan"}),
        ("T1 1 2 3\nT2 1 1e999 3\n", "row 2", "seeds.unusable_coordinate",
         {"axis": "y", "value": "1e999"}),
        ("T1 1 2 3\nT1 4 5 6\n", "row 2", "seeds.duplicate_name", {"name": "T1", "other": 1}),
        ("T1 1 2 3\nT2 1 2 3\n", "row 2", "seeds.duplicate_place", {"other": 1}),
        ("T/1 1 2 3\n", "row 1", "seeds.invalid_name", {}),
        ("name;x;y;z\n;1;2;3\n", "row 2", "seeds.invalid_name", {}),
        ("name x y z role\nT1 1 2 3 wall\n", "row 2", "seeds.unknown_role", {"role": "wall"}),
        ("name x y\nT1 1 2\n", "row 1", "seeds.columns_missing_in_row", {"names": ("z",)}),
        ("name x y z x\nT1 1 2 3 4\n", "row 1", "seeds.duplicate_columns_in_row",
         {"names": ("x",)}),
        ("name easting northing h\nT1 1 2 3\n", "row 1", "seeds.other_axes_in_row",
         {"names": ("easting",)}),
        ("T1 1 2 3\n\0\n", "row 2", "text.not_text", {}),
    ],
)  # fmt: skip
def test_invalid_lists_are_refused_with_file_and_row(
    tmp_path: Path, text: str, row: str, code: str, params: dict[str, object]
) -> None:
    path = written(tmp_path, text)
    with pytest.raises(InputError) as refused:
        read_point_list(path)
    message = refused.value.message
    assert message is not None
    assert message.code == code
    assert dict(message.params).items() >= params.items()
    text = str(refused.value)
    assert text.startswith(f"{path}, {row}: " if row else f"{path}: ")
    assert "\n" not in text
    assert not is_point_list(path)


def test_a_cloud_is_not_read_as_a_list(tmp_path: Path) -> None:
    path = written(tmp_path, "".join(f"P{k} {k} 2 3\n" for k in range(1001)))
    with pytest.raises(InputError, check=has_code("seeds.too_many_rows", most=1000)):
        read_point_list(path)
    with pytest.raises(InputError, check=has_code("file.not_found")):
        read_point_list(tmp_path / "missing.txt")


@pytest.mark.parametrize(
    ("text", "sigma", "plane"),
    [("P1 1 2 3 0.004 quay\n", 0.004, "quay"), ("P1 1 2 3 0.004\n", 0.004, "")],
)
def test_columns_of_check_points_are_found_by_their_order(
    tmp_path: Path, text: str, sigma: float, plane: str
) -> None:
    """The fifth column of check points is the sigma; lists of targets have no sigma."""
    (point,) = read_point_list(written(tmp_path, text), check=True).points
    assert (point.name, point.coordinates) == ("P1", (1.0, 2.0, 3.0))
    assert (point.sigma, point.plane) == (sigma, plane)
    with pytest.raises(InputError, check=has_code("seeds.order_unclear", row=1)):
        read_point_list(written(tmp_path, text))
