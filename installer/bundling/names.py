"""Names and version for the bundles for Linux, Windows and macOS."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).resolve().parents[2]
PROGRAM_NAME = "LISPAC"
SUMMARY = "Boresight calibration of a LiDAR and an INS/GNSS on a vessel"
SUMMARY_FR = "Étalonnage des angles de visée d'un LiDAR et d'une centrale inertielle sur un navire"
PUBLISHER = "LISPAC developers"
IDENTIFIER = "org.lispac.lispac"
COMMAND_LINE_PROGRAM = "lispac"
WINDOW_PROGRAM = "lispac-gui"
PROGRAMS = (COMMAND_LINE_PROGRAM, WINDOW_PROGRAM)
"""File names of the two programs of a bundle, without a suffix: command line and window."""
PROJECT_SUFFIX = "lispac"
"""Suffix, without the point, of the file in a project folder that opens the project
(lispac/io/project/project_file.py)."""
MIME_TYPE = "application/x-lispac-project"
DOCUMENT_NAME = "LISPAC project"
DOCUMENT_NAME_FR = "Projet LISPAC"
ICON_PNG = CHECKOUT / "resources" / "icons" / "lispac.png"
ICON_SVG = ICON_PNG.with_suffix(".svg")


def version() -> str:
    """Version of the program, read from `lispac/version.py` without importing the package."""
    text = (CHECKOUT / "lispac" / "version.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"', text, re.MULTILINE)
    if found is None:
        raise ValueError("lispac/version.py contains no version")
    return found.group(1)


def shared() -> dict[str, str]:
    """Values for the scripts for Windows and macOS, by the variable names of the scripts."""
    return {
        "AppName": PROGRAM_NAME,
        "AppVersion": version(),
        "AppSummary": SUMMARY,
        "AppPublisher": PUBLISHER,
        "AppIdentifier": IDENTIFIER,
        "CommandLine": COMMAND_LINE_PROGRAM,
        "Window": WINDOW_PROGRAM,
        "Ending": PROJECT_SUFFIX,
        "MimeType": MIME_TYPE,
        "Document": DOCUMENT_NAME,
        "DocumentFr": DOCUMENT_NAME_FR,
    }


def for_inno_setup(values: dict[str, str]) -> str:
    """Names as definitions for Inno Setup, which installer/windows/lispac.iss includes."""
    return "".join(f'#define {key} "{value}"\n' for key, value in values.items())


def for_shell(values: dict[str, str]) -> str:
    """Names as shell variables, which installer/macos/make-dmg.sh reads."""
    return "".join(f"{key}='{value}'\n" for key, value in values.items())


def for_macos() -> dict[str, Any]:
    """Entries of Info.plist in addition to name, version and icon, such as the file types."""
    kind = f"{IDENTIFIER}.project"
    return {
        "CFBundleExecutable": WINDOW_PROGRAM,
        # The system's dialogs then use the user's language, as those of LISPAC do
        "CFBundleDevelopmentRegion": "en",
        "CFBundleLocalizations": ["en", "fr"],
        "CFBundleDocumentTypes": [
            {
                "CFBundleTypeName": DOCUMENT_NAME,
                "CFBundleTypeRole": "Editor",
                "LSHandlerRank": "Owner",
                "LSItemContentTypes": [kind],
            }
        ],
        "UTExportedTypeDeclarations": [
            {
                "UTTypeIdentifier": kind,
                "UTTypeDescription": DOCUMENT_NAME,
                "UTTypeConformsTo": ["public.data"],
                "UTTypeTagSpecification": {
                    "public.filename-extension": [PROJECT_SUFFIX],
                    "public.mime-type": MIME_TYPE,
                },
            }
        ],
        "NSHighResolutionCapable": True,
        "LSMinimumSystemVersion": "13.0",
    }
