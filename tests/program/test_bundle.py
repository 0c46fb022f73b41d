"""Tests of the contents of a bundle, and of the names shared by the three systems."""

import ast
import configparser
import plistlib
import re
import shutil
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from bundling import build, desktop, licences, names, sizes, trimming

import lispac
from lispac.io.project.project_file import OPENER_ENDING, OPENER_NAME
from lispac.language import LANGUAGES
from tests.extras.clean_root import Root

CHECKOUT = Path(__file__).resolve().parents[2]
WINDOWS = (CHECKOUT / "installer" / "windows" / "lispac.iss").read_text(encoding="utf-8")
MACOS = (CHECKOUT / "installer" / "macos" / "make-dmg.sh").read_text(encoding="utf-8")


def scripts() -> dict[str, str]:
    """Entry points of the programs in pyproject.toml."""
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return project["scripts"] | project["gui-scripts"]


# Names, defined in one place


def test_names_are_those_of_the_package() -> None:
    assert names.version() == lispac.__version__
    assert set(names.PROGRAMS) == set(scripts())
    assert f".{names.PROJECT_SUFFIX}" == OPENER_ENDING
    assert OPENER_NAME.endswith(OPENER_ENDING)
    assert build.bundle_name().startswith(f"lispac-{lispac.__version__}-")


def test_both_programs_start_the_entry_points_of_the_package() -> None:
    start = (CHECKOUT / "installer" / "bundling" / "start.py").read_text(encoding="utf-8")
    (line,) = re.findall(r"^MAIN_MODULES = (.*)", start, re.MULTILINE)
    assert {name: f"{module}:main" for name, module in ast.literal_eval(line).items()} == scripts()


@pytest.mark.parametrize(
    ("script", "used"),
    [(WINDOWS, r"\{#(\w+)\}"), (MACOS, r"\$(?:\{)?([A-Z][a-z]\w+)")],
    ids=["windows", "macos"],
)
def test_installer_scripts_define_no_names_themselves(script: str, used: str) -> None:
    known = {*names.shared(), "BundleFolder", "BundleName"}
    assert set(re.findall(used, script)) <= known
    assert {"AppName", "AppVersion", "BundleName", "CommandLine", "Window"} <= set(
        re.findall(used, script)
    )
    lines = script.splitlines()
    rules = "\n".join(line for line in lines if not line.lstrip().startswith((";", "#")))
    assert lispac.__version__ not in script
    for name in (names.WINDOW_PROGRAM, names.IDENTIFIER, names.MIME_TYPE, names.DOCUMENT_NAME):
        assert name not in rules


def test_names_reach_inno_setup_and_the_shell() -> None:
    values = {"AppName": "LISPAC", "AppVersion": "1.2.3"}
    assert names.for_inno_setup(values) == '#define AppName "LISPAC"\n#define AppVersion "1.2.3"\n'
    command = names.for_shell(names.shared()) + 'printf "%s|%s" "$AppVersion" "$AppSummary"'
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=True)
    assert done.stdout == f"{lispac.__version__}|{names.SUMMARY}"


def test_windows_and_macos_open_the_same_files_with_the_window() -> None:
    opened = [line for line in WINDOWS.splitlines() if r"shell\open\command" in line]
    assert len(opened) == 1
    assert "{#Window}.exe" in opened[0]
    assert r"Software\Classes\.{#Ending}" in WINDOWS
    plist = plistlib.loads(plistlib.dumps(names.for_macos()))
    (kind,) = plist["UTExportedTypeDeclarations"]
    assert kind["UTTypeTagSpecification"]["public.filename-extension"] == [names.PROJECT_SUFFIX]
    assert plist["CFBundleDocumentTypes"][0]["LSItemContentTypes"] == [kind["UTTypeIdentifier"]]
    assert plist["CFBundleExecutable"] == names.WINDOW_PROGRAM
    assert plist["CFBundleLocalizations"] == list(LANGUAGES)
    for code, language in (("en", "english"), ("fr", "french")):
        assert code in LANGUAGES
        assert f'Name: "{language}"' in WINDOWS
        assert f"{language}.Document=" in WINDOWS


def test_the_hardened_runtime_of_macos_has_the_entitlements_for_numba() -> None:
    (signed, sealed) = re.findall(r"codesign (?:[^\\\n]|\\\n)*", MACOS)
    assert "--options runtime" in signed
    assert '--sign "$CODESIGN_IDENTITY"' in signed
    (file,) = re.findall(r'--entitlements "\$checkout/(.*?)"', signed)
    granted = plistlib.loads((CHECKOUT / file).read_bytes())
    required = ("allow-jit", "allow-unsigned-executable-memory")
    assert granted == {f"com.apple.security.cs.{name}": True for name in required}
    # Without a certificate the libraries would not have the same developer ID
    assert "--sign -" in sealed
    assert "runtime" not in sealed


def test_shell_scripts_have_valid_syntax() -> None:
    for script in (MACOS, desktop.INSTALL_SCRIPT, desktop.UNINSTALL_SCRIPT):
        done = subprocess.run(["sh", "-n"], input=script, text=True, check=False)
        assert done.returncode == 0


# Desktop integration


def test_the_icon_exists_as_svg_and_png() -> None:
    assert ElementTree.parse(names.ICON_SVG).getroot().get("viewBox") == "0 0 256 256"
    data = names.ICON_PNG.read_bytes()
    assert data.startswith(b"\x89PNG")
    assert [int.from_bytes(data[at : at + 4], "big") for at in (16, 20)] == [256, 256]


def made_bundle(folder: Path) -> Path:
    """Make a bundle with programs that do nothing."""
    folder.mkdir(parents=True)
    for program in names.PROGRAMS:
        (folder / program).write_text("#!/bin/sh\n")
        (folder / program).chmod(0o755)
    desktop.write_into(folder)
    return folder


def test_desktop_entry_and_file_type_agree() -> None:
    entry = configparser.ConfigParser(interpolation=None)
    entry.optionxform = str
    entry.read_string(desktop.DESKTOP_ENTRY)
    keys = entry["Desktop Entry"]
    assert {"Type", "Name", "Exec", "Icon", "Categories", "MimeType"} <= set(keys)
    assert keys["Exec"].endswith(" %f")
    root = ElementTree.fromstring(desktop.FILE_TYPE_XML.encode())
    space = "{http://www.freedesktop.org/standards/shared-mime-info}"
    (kind,) = root.findall(f"{space}mime-type")
    assert keys["MimeType"] == f"{kind.get('type')};"
    assert kind.find(f"{space}glob").get("pattern") == f"*{OPENER_ENDING}"
    assert kind.find(f"{space}icon").get("name") == keys["Icon"]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="these scripts are for Linux")
def test_uninstalling_removes_all_installed_files(tmp_path: Path) -> None:
    bundle, prefix = made_bundle(tmp_path / "unpacked here"), tmp_path / "a prefix"
    (prefix / "bin").mkdir(parents=True)
    (prefix / "bin" / "other").touch()
    for _twice in range(2):
        subprocess.run([bundle / "install.sh", prefix], check=True, capture_output=True)
    entry = (prefix / "share/applications/lispac.desktop").read_text(encoding="utf-8")
    window = prefix / "lib" / "lispac" / names.WINDOW_PROGRAM
    assert f'Exec="{window}" %f' in entry
    assert "@" not in entry
    assert (prefix / "bin" / "lispac").resolve() == window.with_name("lispac")
    if shutil.which("desktop-file-validate"):
        subprocess.run(
            ["desktop-file-validate", prefix / "share/applications/lispac.desktop"], check=True
        )
    shutil.rmtree(bundle)
    installed = prefix / "lib" / "lispac"
    subprocess.run([installed / "uninstall.sh", prefix], check=True, capture_output=True)
    remaining = [path for path in prefix.rglob("*lispac*") if path.is_file() or path.is_symlink()]
    assert remaining == []
    assert (prefix / "bin" / "other").exists()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="these scripts are for Linux")
def test_a_foreign_folder_of_that_name_is_not_changed(tmp_path: Path) -> None:
    bundle, prefix = made_bundle(tmp_path / "unpacked"), tmp_path / "prefix"
    (prefix / "lib" / "lispac").mkdir(parents=True)
    (prefix / "lib" / "lispac" / "mine").touch()
    done = subprocess.run(
        [bundle / "install.sh", prefix], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert "does not contain LISPAC" in done.stderr
    subprocess.run([bundle / "uninstall.sh", prefix], check=True, capture_output=True)
    assert (prefix / "lib" / "lispac" / "mine").exists()


# Excluded files


def test_only_needed_libraries_are_bundled() -> None:
    entries = [
        ("vtkmodules/vtkCommonCore.cpython-311.so", "/s/core", "EXTENSION"),
        ("vtkmodules/vtkWebCore.cpython-311.so", "/s/web", "EXTENSION"),
        ("vtkmodules/libvtkCommonCore.so", "/s/libcore", "BINARY"),
        ("vtkmodules/libvtkWebCore.so", "/s/libweb", "BINARY"),
        ("vtkmodules/libvtkzlib.so", "/s/libzlib", "BINARY"),
        ("libvtkWebCore.so", "vtkmodules/libvtkWebCore.so", "SYMLINK"),
        ("libvtkzlib.so", "vtkmodules/libvtkzlib.so", "SYMLINK"),
        ("libgtk-3.so.0", "/usr/lib/libgtk-3.so.0", "BINARY"),
        ("libstdc++.so.6", "/usr/lib/libstdc++.so.6", "BINARY"),
        ("libpython3.11.so.1.0", "/p/libpython3.11.so.1.0", "BINARY"),
        ("PySide6/Qt/plugins/platformthemes/libqgtk3.so", "/s/libqgtk3.so", "BINARY"),
        ("PySide6/Qt/translations/qtbase_fr.qm", "/s/fr.qm", "DATA"),
        ("PySide6/Qt/translations/qtbase_de.qm", "/s/de.qm", "DATA"),
        ("lispac/report/templates/report.typ", "/c/report.typ", "DATA"),
    ]
    needed = {
        "/s/core": ["libvtkCommonCore.so", "libstdc++.so.6"],
        "/s/libcore": ["libvtkzlib.so"],
        "/s/web": ["libvtkWebCore.so"],
        "/s/libqgtk3.so": ["libgtk-3.so.0"],
    }
    used = trimming.without_unused(entries)
    kept = {entry[0] for entry in trimming.trimmed(used, lambda path: needed.get(path, []))}
    assert kept == {
        "vtkmodules/vtkCommonCore.cpython-311.so",
        "vtkmodules/libvtkCommonCore.so",
        "vtkmodules/libvtkzlib.so",
        "libvtkzlib.so",
        "libpython3.11.so.1.0",
        "PySide6/Qt/translations/qtbase_fr.qm",
        "lispac/report/templates/report.typ",
    }


@pytest.mark.parametrize(
    ("plugins", "translations", "file"),
    [
        ("PySide6/Qt/plugins", "PySide6/Qt/translations", "lib{}.so"),
        ("PySide6/Qt/plugins", "PySide6/Qt/translations", "lib{}.dylib"),
        (r"PySide6\plugins", r"PySide6\translations", "{}.dll"),
    ],
    ids=["linux", "macos", "windows"],
)
def test_unused_files_are_excluded_on_every_system(
    plugins: str, translations: str, file: str
) -> None:
    apart = "\\" if "\\" in plugins else "/"
    used = [
        apart.join([plugins, "platforms", file.format("qoffscreen")]),
        apart.join([plugins, "imageformats", file.format("qsvg")]),
        apart.join([translations, "qtbase_fr.qm"]),
        apart.join(["babel", "locale-data", "fr_FR.dat"]),
        apart.join(["numpy", "testing.py"]),
    ]
    unused = [
        apart.join([plugins, "platforms", file.format("qminimal")]),
        apart.join([plugins, "imageformats", file.format("qpdf")]),
        apart.join([plugins, "tls", file.format("qopensslbackend")]),
        apart.join([translations, "qtbase_de.qm"]),
        apart.join(["babel", "locale-data", "de.dat"]),
        apart.join(["numpy", "tests", "test_x.py"]),
    ]
    entries = [(place, "/source", "BINARY") for place in [*used, *unused]]
    assert [entry[0] for entry in trimming.without_unused(entries)] == used


@pytest.mark.parametrize(
    "place",
    [
        "_internal/PySide6/Qt/lib/libQt6WebEngineCore.so.6",
        "_internal/PySide6/QtQml.abi3.so",
        "_internal/IPython/core/magic.py",
        "_internal/open3d/nbextension/index.js",
        "_internal/matplotlib/mpl-data/sample_data/jacksboro.csv",
        "_internal/numpy/tests/test_x.py",
        "_internal/pip/__init__.py",
    ],
)
def test_unwanted_files_in_a_bundle_are_found(place: str) -> None:
    assert trimming.unwanted(["_internal/lispac/cli/main.py", place]) == [place]


@pytest.mark.skipif(sys.platform == "win32", reason="a program there is no script")
@pytest.mark.parametrize("ending", ["", ".exe"])
def test_a_bundle_of_another_version_is_refused(
    ending: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build.sysconfig, "get_config_var", {"EXE": ending}.get)
    program = tmp_path / f"lispac{ending}"
    program.write_text(f'#!/bin/sh\necho "lispac {lispac.__version__}$HOME"\n')
    program.chmod(0o755)
    build.require_fit(tmp_path)
    program.write_text("#!/bin/sh\necho lispac 0.0\n")
    with pytest.raises(build.BundleError, match=r"lispac 0\.0"):
        build.require_fit(tmp_path)


def test_modules_of_lispac_are_not_excluded_as_test_data() -> None:
    places = [path.relative_to(CHECKOUT).as_posix() for path in (CHECKOUT / "lispac").rglob("*.py")]
    assert trimming.unwanted(f"_internal/{place}" for place in places) == []


def test_modules_that_the_program_imports_are_not_excluded() -> None:
    """Campaigns on a cluster and building the manual need the installation with Python."""
    imported = set()
    for path in (CHECKOUT / "lispac").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_bytes())):
            if isinstance(node, ast.Import):
                imported |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module:
                imported |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    excluded = {
        name for name in trimming.UNUSED_MODULES
        if any(each == name or each.startswith(f"{name}.") for each in imported)
    }  # fmt: skip
    assert excluded <= {"dask", "distributed", "sphinx"}


READS_NUMBERS = """
import sys
opened = []
sys.addaudithook(lambda event, args: opened.append(args[0]) if event == "open" else None)
from datetime import datetime
from lispac import language
for code in language.LANGUAGES:
    language.use_language(code)
    language.number(1.5), language.join_names(["a", "b"]), language.short_datetime(datetime.now())
print(*(path for path in opened if str(path).endswith(".dat")), sep="\\n")
"""


def test_locale_data_of_all_languages_are_kept() -> None:
    command = [sys.executable, "-c", READS_NUMBERS]
    done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=True)
    opened = [Path(line) for line in done.stdout.splitlines()]
    assert {"en.dat", "fr.dat"} <= {path.name for path in opened}
    entries = [
        (path.as_posix()[path.as_posix().rindex("babel/") :], str(path), "DATA") for path in opened
    ]
    assert trimming.without_unused(entries) == entries


def test_vtk_modules_of_the_view_are_kept() -> None:
    view = CHECKOUT / "lispac" / "gui" / "viewport"
    text = "".join(path.read_text(encoding="utf-8") for path in view.glob("*.py"))
    used = set(re.findall(r"from vtkmodules\.vtk(\w+) import", text))
    assert used
    assert used <= set(trimming.VTK_MODULES)


def test_the_bundle_contains_bytecode(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "pycache_prefix", str(tmp_path / "elsewhere"))
    (tmp_path / "package").mkdir()
    (tmp_path / "package" / "module.py").write_text("answer = 42\n")
    build.compile_sources(tmp_path / "package")
    assert len(list((tmp_path / "package" / "__pycache__").glob("module.*.pyc"))) == 1
    assert sys.pycache_prefix == str(tmp_path / "elsewhere")


def test_the_app_of_macos_has_licences_and_bytecode_too(tmp_path: Path) -> None:
    app, made = tmp_path / "LISPAC.app", tmp_path / "lispac"
    package = app / "Contents" / "Resources" / "lispac"
    package.mkdir(parents=True)
    made.mkdir()
    (package / "module.py").write_text("answer = 42\n")
    (made / licences.FILE_NAME).write_text("all of them")
    build.finish_macos(app, made)
    assert (package.parent / licences.FILE_NAME).read_text() == "all of them"
    assert len(list((package / "__pycache__").glob("module.*.pyc"))) == 1


def test_hard_links_count_once_in_sizes(tmp_path: Path) -> None:
    inside = tmp_path / "_internal" / "numpy.libs"
    inside.mkdir(parents=True)
    (inside / "a.so").write_bytes(b"0" * 3_000_000)
    (tmp_path / "lispac").write_bytes(b"0" * 1_000_000)
    (tmp_path / "lispac-gui").hardlink_to(tmp_path / "lispac")
    (tmp_path / "_internal" / "libz.so").symlink_to("numpy.libs/a.so")
    found = sizes.by_part(tmp_path)
    assert found["numpy"] == 3_000_000
    assert sum(found.values()) == 4_000_000
    rows = sizes.table(found)
    assert rows[0].split() == ["numpy", "3.0", "MB"]
    assert rows[-1].split() == ["whole", "4.0", "MB"]


def test_a_clean_root_cannot_write_to_this_machine(tmp_path: Path) -> None:
    (tmp_path / "given").write_text("ours")
    root = Root(tmp_path / "root", [str(tmp_path / "given")])
    root.give()
    assert "bind" not in " ".join(root.command("true"))
    copied = root.folder / str(tmp_path / "given").lstrip("/")
    copied.write_text("theirs")
    assert (tmp_path / "given").read_text() == "ours"
