"""Files that are omitted from the bundle, and files that it must not contain."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import PurePosixPath

# Open3D, PyVista and Numba import these for notebooks, web pages and developers; Sphinx and its
# dependencies are installed because the manual is built in this environment.
UNUSED_MODULES = [
    "IPython",
    "PyInstaller",
    "PyQt5",
    "PyQt6",
    "PySide6.QtNetwork",
    "_tkinter",
    "dash",
    "dask",
    "distributed",
    "docutils",
    "flask",
    "furo",
    "imageio",
    "ipywidgets",
    "jedi",
    "jsonschema",
    "jupyter",
    "matplotlib.backends.backend_tkagg",
    "myst_parser",
    "nbformat",
    "notebook",
    "open3d._ml3d",
    "open3d.app",
    "open3d.examples",
    "open3d.ml",
    "open3d.tools",
    "open3d.visualization.draw_plotly",
    "open3d.web_visualizer",
    "pandas",
    "pip",
    "plotly",
    "pytest",
    "setuptools",
    "sklearn",
    "sphinx",
    "tkinter",
    "tornado",
    "trame",
    "werkzeug",
]
# Qt's plugins for screens without X or Wayland, for networks and for the dialogues of GTK (which
# would add GTK to the bundle); plugins for image formats that LISPAC does not read; translations
# into other languages; test files and examples.
UNUSED_FILE_PATTERNS = [
    r"PySide6/(Qt/)?plugins/(egldeviceintegrations|generic|networkinformation|tls)/",
    r"PySide6/(Qt/)?plugins/platforms/(lib)?q(eglfs|linuxfb|minimal|minimalegl|vkkhrdisplay|vnc)\.",
    r"PySide6/(Qt/)?plugins/platformthemes/libqgtk3\.",
    r"PySide6/(Qt/)?plugins/imageformats/(lib)?q(icns|pdf|tga|tiff|wbmp|webp)\.",
    r"PySide6/(Qt/)?translations/(?!qt(base)?_(en|fr)\.qm$)",
    r"babel/locale-data/(?!(root|en|en_001|en_GB|fr|fr_FR)\.dat$)",
    r"matplotlib/mpl-data/(sample_data|plot_directive)/",
    r"pillow\.libs/libavif|PIL/(_avif|\.dylibs/libavif)",
    r"(.*/)?tests?/",
]
# The modules that are loaded when all modules of the window are imported and the built-in survey
# is displayed. Libraries that they depend on are added; the rest of VTK is omitted.
VTK_MODULES = [
    "ChartsCore",
    "CommonColor",
    "CommonComputationalGeometry",
    "CommonCore",
    "CommonDataModel",
    "CommonExecutionModel",
    "CommonMath",
    "CommonMisc",
    "CommonSystem",
    "CommonTransforms",
    "FiltersCore",
    "FiltersExtraction",
    "FiltersGeneral",
    "FiltersGeometry",
    "FiltersModeling",
    "FiltersPython",
    "FiltersSources",
    "FiltersStatistics",
    "FiltersTexture",
    "FiltersVerdict",
    "IOCore",
    "IOImage",
    "IOLegacy",
    "IOXML",
    "ImagingColor",
    "ImagingCore",
    "ImagingGeneral",
    "ImagingHybrid",
    "ImagingMath",
    "ImagingSources",
    "InteractionStyle",
    "InteractionWidgets",
    "ParallelCore",
    "PythonContext2D",
    "RenderingAnnotation",
    "RenderingContext2D",
    "RenderingContextOpenGL2",
    "RenderingCore",
    "RenderingFreeType",
    "RenderingHyperTreeGrid",
    "RenderingLabel",
    "RenderingMatplotlib",
    "RenderingOpenGL2",
    "RenderingUI",
    "RenderingVolume",
    "RenderingVolumeOpenGL2",
    "ViewsContext2D",
    "ViewsCore",
]
# Every Linux desktop has these libraries in versions that fit its graphics driver. An older copy in
# the bundle, above all of libstdc++, could prevent OpenGL from starting. Source: the list of
# libraries that an AppImage must not contain.
SYSTEM_LIBRARY_PATTERNS = [
    r"lib(stdc\+\+|gcc_s|GL|EGL|GLX|GLdispatch|OpenGL|glapi|gbm|drm|xcb|xcb-dri[23]|X11|X11-xcb)\.so",
    r"lib(wayland-\w+|fontconfig|freetype|harfbuzz|expat|z|uuid|com_err|gpg-error|usb-1\.0|udev)\.so",
    r"lib(p11-kit|ICE|SM|thai|fribidi|asound|jack)\.so",
]
FORBIDDEN_PATHS = [
    r"WebEngine|QtWeb|QtQuick|QtQml|Qt6(Qml|Quick|Pdf|Designer|3D|Multimedia)",
    r"(^|/)(IPython|notebook|jupyter\w*|ipywidgets|nbformat|dash|plotly|flask|tkinter)(/|$)",
    r"(^|/)(nbextension|labextension)(/|$)",
    r"(^|/)tests?(/|$)|(^|/)(sample_data|testdata|baseline_images)(/|$)|libvtkTesting",
    r"(^|/)(pytest|hypothesis|mypy|ruff|pip|setuptools|hatchling)(/|$)",
    r"(^|/)(sphinx|docutils|myst_parser|furo)(/|$)",
    r"(^|/)lib(gtk|gdk)-3",
]
"""Regular expressions of paths that the finished bundle must not contain."""

Entry = tuple[str, str, str]
"""Path in the bundle, source path, and PyInstaller's type code."""


def _matches(patterns: Iterable[str], text: str) -> bool:
    return any(re.match(pattern, text) for pattern in patterns)


def is_optional(place: str) -> bool:
    """Whether a library is included only if another library needs it.

    Parameters
    ----------
    place : str, path in the bundle with forward slashes
    """
    path = PurePosixPath(place)
    if path.name.startswith("libpython"):
        return False  # the program itself loads it
    if place.startswith("vtkmodules/") and ".so" in path.name:
        module = path.name.partition(".")[0]
        return module.removeprefix("vtk") not in VTK_MODULES
    return (
        len(path.parts) == 1 or place.startswith("PySide6/Qt/lib/") or path.parts[0][-5:] == ".libs"
    ) and ".so" in path.name


def without_unused(entries: Iterable[Entry]) -> list[Entry]:
    """Files of the bundle without those that LISPAC does not use on any system."""
    return [
        entry
        for entry in entries
        if not _matches(UNUSED_FILE_PATTERNS, entry[0].replace("\\", "/"))
    ]


def trimmed(entries: Sequence[Entry], needs: Callable[[str], Iterable[str]]) -> list[Entry]:
    """Files of a Linux bundle without unused libraries and libraries that every desktop has.

    Parameters
    ----------
    entries : sequence of Entry
    needs : function that returns the names of the libraries that a source file is linked against
    """
    links = [entry for entry in entries if entry[2] == "SYMLINK"]
    wanted = [
        entry
        for entry in entries
        if entry[2] != "SYMLINK" and not _matches(SYSTEM_LIBRARY_PATTERNS, entry[0])
    ]
    kept = [entry for entry in wanted if not is_optional(entry[0])]
    optional: dict[str, list[Entry]] = {}
    for entry in wanted:
        if is_optional(entry[0]):
            optional.setdefault(PurePosixPath(entry[0]).name, []).append(entry)
    waiting = [entry for entry in kept if entry[2] in ("BINARY", "EXTENSION")]
    while waiting:
        for name in needs(waiting.pop()[1]):
            found = optional.pop(name, [])
            kept += found
            waiting += found
    places = {entry[0] for entry in kept}
    for place, target, kind in links:
        if str(PurePosixPath(place).parent / target) in places:
            kept.append((place, target, kind))
    return kept


def unwanted(places: Iterable[str]) -> list[str]:
    """Paths among those of a finished bundle that `FORBIDDEN_PATHS` excludes."""
    return [
        place for place in places if any(re.search(pattern, place) for pattern in FORBIDDEN_PATHS)
    ]
