"""Names shared by the bundles for Linux, Windows and macOS; the version is the package's."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).resolve().parents[2]
NAME = "LISPAC"
SUMMARY = "Boresight calibration of a LiDAR and an INS/GNSS on a vessel"
SUMMARY_FR = "Étalonnage des angles de visée d'un LiDAR et d'une centrale inertielle sur un navire"
PUBLISHER = "LISPAC developers"
IDENTIFIER = "org.lispac.lispac"
COMMAND_LINE = "lispac"
WINDOW = "lispac-gui"
PROGRAMS = (COMMAND_LINE, WINDOW)
"""The two programs of a bundle, in one folder: command line and window."""
ENDING = "lispac"
"""Suffix of the file that opens the project in its folder (lispac/io/project/project_file.py)."""
MIME_TYPE = "application/x-lispac-project"
DOCUMENT = "LISPAC project"
DOCUMENT_FR = "Projet LISPAC"
ICON = CHECKOUT / "resources" / "icons" / "lispac.png"
ICON_DRAWING = ICON.with_suffix(".svg")


def version() -> str:
    """The version as `lispac/__init__.py` states it, without importing the package."""
    text = (CHECKOUT / "lispac" / "__init__.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"', text, re.MULTILINE)
    if found is None:
        raise ValueError("lispac/__init__.py states no version")
    return found.group(1)


def shared() -> dict[str, str]:
    """Values for the scripts for Windows and macOS, by the variable names of the scripts."""
    return {
        "AppName": NAME,
        "AppVersion": version(),
        "AppSummary": SUMMARY,
        "AppPublisher": PUBLISHER,
        "AppIdentifier": IDENTIFIER,
        "CommandLine": COMMAND_LINE,
        "Window": WINDOW,
        "Ending": ENDING,
        "MimeType": MIME_TYPE,
        "Document": DOCUMENT,
        "DocumentFr": DOCUMENT_FR,
    }


def for_inno_setup(values: dict[str, str]) -> str:
    """The names as installer/windows/lispac.iss includes them."""
    return "".join(f'#define {key} "{value}"\n' for key, value in values.items())


def for_shell(values: dict[str, str]) -> str:
    """The names as installer/macos/make-dmg.sh reads them."""
    return "".join(f"{key}='{value}'\n" for key, value in values.items())


def for_macos() -> dict[str, Any]:
    """Entries of Info.plist besides name, version and icon: file types that the window opens."""
    kind = f"{IDENTIFIER}.project"
    return {
        "CFBundleExecutable": WINDOW,
        # The system's dialogs then use the user's language, as those of LISPAC do
        "CFBundleDevelopmentRegion": "en",
        "CFBundleLocalizations": ["en", "fr"],
        "CFBundleDocumentTypes": [
            {
                "CFBundleTypeName": DOCUMENT,
                "CFBundleTypeRole": "Editor",
                "LSHandlerRank": "Owner",
                "LSItemContentTypes": [kind],
            }
        ],
        "UTExportedTypeDeclarations": [
            {
                "UTTypeIdentifier": kind,
                "UTTypeDescription": DOCUMENT,
                "UTTypeConformsTo": ["public.data"],
                "UTTypeTagSpecification": {
                    "public.filename-extension": [ENDING],
                    "public.mime-type": MIME_TYPE,
                },
            }
        ],
        "NSHighResolutionCapable": True,
        "LSMinimumSystemVersion": "13.0",
    }
