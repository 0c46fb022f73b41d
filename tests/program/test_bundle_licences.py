"""Tests that one file contains the licences of everything in a bundle."""

import re
import sys
from importlib.metadata import distribution
from pathlib import Path

import pytest
from bundling import build, licences

CHECKOUT = Path(__file__).resolve().parents[2]


def made_distribution(site: Path, name: str, licence: str | None) -> Path:
    """Make a package as pip installs it and return its module."""
    info = site / f"{name}-1.0.dist-info"
    info.mkdir(parents=True)
    (site / f"{name}.py").touch()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    record = f"{name}.py,,\n{name}-1.0.dist-info/METADATA,,\n"
    if licence is not None:
        (info / "licenses").mkdir()
        (info / "licenses" / "LICENSE").write_text(licence)
        record += f"{name}-1.0.dist-info/licenses/LICENSE,,\n"
    (info / "RECORD").write_text(record)
    return site / f"{name}.py"


def test_licences_of_bundled_packages_are_in_one_file(tmp_path: Path) -> None:
    site = tmp_path / "site-packages"
    used = made_distribution(site, "used", "Do as you like.")
    made_distribution(site, "unused", "Never.")
    found = licences.collected([used], site, CHECKOUT, licences.read_notices())
    text = licences.written(found)
    assert "used 1.0" in text
    assert "Do as you like." in text
    assert "Never." not in text
    assert "BSD 3-Clause" in text
    assert "PYTHON SOFTWARE FOUNDATION" in text


@pytest.mark.parametrize("place", ["DLLs/libssl-3.dll", "vcruntime140.dll", "Lib/json/__init__.py"])
def test_libraries_of_windows_python_are_covered_by_its_licence(
    place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    python = tmp_path / "Python311"
    python.mkdir()
    (python / "LICENSE.txt").write_text("PSF, and OpenSSL.")
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(sys, "base_prefix", str(python))
    monkeypatch.setattr(licences.sysconfig, "get_path", lambda name: str(python / "Lib"))
    site = python / "Lib" / "site-packages"
    found = licences.collected([python / place], site, CHECKOUT, licences.read_notices())
    assert "PSF, and OpenSSL." in licences.written(found)
    with pytest.raises(licences.LicenceMissingError, match="loose"):
        licences.collected([site / "loose.py"], site, CHECKOUT, licences.read_notices())


@pytest.mark.parametrize(
    ("place", "name"),
    [
        ("numpy.libs/libscipy_openblas64_-fb1711452d4d8cee9f276fd1449ee5c7.dll", "OpenBLAS"),
        ("numpy.libs/msvcp140-d64049c6e3865410a7dda6a7e9f0c575.dll", "Microsoft Visual C++"),
        ("pyproj.libs/proj_9-4a1d7ddd5e4cfa3be5d3d4d0e9e1b0c9.dll", "PROJ"),
        ("vtkmodules/vtkzlib-9.5.dll", "zlib"),
        ("numpy/.dylibs/libgfortran.5.dylib", "GCC runtime"),
        ("vtkmodules/.dylibs/libvtkexpat-9.5.dylib", "Expat"),
        ("open3d/tbb12.dll", "Threading Building Blocks"),
    ],
)
def test_libraries_within_wheels_are_recognised_by_name(place: str, name: str) -> None:
    path = Path("/site-packages") / place
    assert licences.is_foreign(path)
    notice = licences.library_notice(path.name, licences.read_notices())
    assert notice is not None
    assert name in notice["name"]


def test_libraries_of_the_authors_of_a_wheel_are_not_foreign() -> None:
    for name in ("vtkCommonCore-9.5.dll", "libvtkCommonCore-9.5.dylib", "Open3D.dll", "vtk.py"):
        assert not licences.is_foreign(Path("/site-packages/vtkmodules") / name)


def test_only_files_need_a_licence() -> None:
    listed = [
        ("libz.so", "vtkmodules/libz.so", "SYMLINK"),
        ("mpl_toolkits", "-", "PYMODULE"),
        ("scipy", "/site/scipy/__init__.py", "PYMODULE"),
        ("json", "", "PYMODULE"),
    ]
    assert build.sources_of(listed) == [Path("/site/scipy/__init__.py")]


def test_a_part_without_licence_text_stops_the_build(tmp_path: Path) -> None:
    used = made_distribution(tmp_path, "silent", None)
    with pytest.raises(
        licences.LicenceMissingError, match=r"silent comes without .* notices\.toml"
    ):
        licences.collected([used], tmp_path, CHECKOUT, licences.read_notices())


def test_an_unknown_library_stops_the_build(tmp_path: Path) -> None:
    folder = tmp_path / "numpy.libs"
    folder.mkdir()
    (folder / "libstrange-12ab.so.1").touch()
    with pytest.raises(licences.LicenceMissingError, match="libstrange"):
        licences.collected(
            [folder / "libstrange-12ab.so.1"], tmp_path, CHECKOUT, licences.read_notices()
        )


def test_a_file_of_no_package_stops_the_build(tmp_path: Path) -> None:
    (tmp_path / "loose.py").touch()
    with pytest.raises(licences.LicenceMissingError, match="belongs to no package"):
        licences.collected([tmp_path / "loose.py"], tmp_path, CHECKOUT, licences.read_notices())


def test_notices_refer_to_existing_texts() -> None:
    notices = licences.read_notices()
    texts = [*notices["shared_texts"]]
    for row in notices["distribution"].values():
        texts += row.get("texts", ())
    assert all((licences.TEXT_FOLDER / name).stat().st_size > 1000 for name in texts)
    for row in notices["library"]:
        re.compile(row["file"])
        assert row["licence"]


def test_the_licences_name_all_parts_of_the_manual_theme() -> None:
    notices = licences.read_notices()
    texts = {
        name: "\n".join(licences.texts_of(distribution(name), notices))
        for name in licences.MANUAL_PAGE_PACKAGES
    }
    assert "Snowball project" in texts["snowballstemmer"]
    assert "Permission is hereby granted" in texts["furo"]
    theme = Path(str(distribution("furo").locate_file("furo/theme/furo")))
    banners = [*theme.rglob("*.css"), *theme.rglob("*.LICENSE.txt")]
    others = {
        name
        for file in banners
        for name in re.findall(r"([\w.-]+) v\d+\.\d+\.\d+", file.read_text("utf-8"))
    }
    drawn = (theme / "partials" / "icons.html").read_text("utf-8")
    others |= {name.title() for name in re.findall(r"\b(feather|tabler)-", drawn)}
    assert others == {"gumshoejs", "normalize.css", "Feather", "Tabler"}
    assert all(name in texts["furo"] for name in others)


def test_the_licence_of_qt_is_the_lgpl() -> None:
    row = licences.read_notices()["distribution"]["pyside6-essentials"]
    assert "LGPL-3.txt" in row["texts"]
    assert "LESSER GENERAL PUBLIC LICENSE" in (licences.TEXT_FOLDER / "LGPL-3.txt").read_text()
    assert "may be replaced" in " ".join(row["note"].split())
