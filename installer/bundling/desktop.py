"""Desktop entry, file type and the scripts that install and remove a bundle on Linux."""

from __future__ import annotations

import shutil
from pathlib import Path

from bundling import names

DESKTOP_ENTRY = f"""[Desktop Entry]
Type=Application
Name={names.PROGRAM_NAME}
GenericName=LiDAR boresight calibration
GenericName[fr]=Étalonnage d'un LiDAR
Comment={names.SUMMARY}
Comment[fr]={names.SUMMARY_FR}
Exec=@PROGRAM@ %f
TryExec=@PROGRAM@
Icon={names.COMMAND_LINE_PROGRAM}
Terminal=false
Categories=Science;Geoscience;
Keywords=LiDAR;boresight;hydrography;INS;GNSS;
MimeType={names.MIME_TYPE};
StartupWMClass={names.WINDOW_PROGRAM}
"""
FILE_TYPE_XML = f"""<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="{names.MIME_TYPE}">
    <comment>{names.DOCUMENT_NAME}</comment>
    <comment xml:lang="fr">{names.DOCUMENT_NAME_FR}</comment>
    <icon name="{names.COMMAND_LINE_PROGRAM}"/>
    <glob pattern="*.{names.PROJECT_SUFFIX}"/>
  </mime-type>
</mime-info>
"""
SHELL_PATHS = f"""here=$(cd "$(dirname "$0")" && pwd -P)
prefix=${{1:-${{HOME:?}}/.local}}
case $prefix in
    -*) echo "usage: $0 [PREFIX]  (default: ~/.local; all users, as root: /usr/local)"; exit 2 ;;
    /*) ;;
    *) echo "$prefix is not an absolute path. Give one, for example /usr/local." >&2; exit 2 ;;
esac
folder=$prefix/lib/{names.COMMAND_LINE_PROGRAM}
entry=$prefix/share/applications/{names.COMMAND_LINE_PROGRAM}.desktop
type=$prefix/share/mime/packages/{names.COMMAND_LINE_PROGRAM}.xml
icons=$prefix/share/icons/hicolor
drawing=$icons/scalable/apps/{names.COMMAND_LINE_PROGRAM}.svg
picture=$icons/256x256/apps/{names.COMMAND_LINE_PROGRAM}.png
renew() {{
    # Tools and folders that a desktop lacks are skipped
    refresh update-mime-database "$prefix/share/mime"
    refresh update-desktop-database "$prefix/share/applications"
    refresh gtk-update-icon-cache "$icons"
}}
refresh() {{
    if [ -d "$2" ] && command -v "$1" >/dev/null; then
        "$1" "$2" >/dev/null 2>&1 || echo "$1 $2 failed. The menu may show the change later." >&2
    fi
}}
"""
INSTALL_SCRIPT = f"""#!/bin/sh
# Copies {names.PROGRAM_NAME} to PREFIX/lib and adds menu entry, icon, file type and links in
# PREFIX/bin.
set -eu
{SHELL_PATHS}
if [ -e "$folder" ] && [ ! -x "$folder/{names.WINDOW_PROGRAM}" ]; then
    echo "$folder exists but does not contain {names.PROGRAM_NAME}. Move it, then start again." >&2
    exit 1
fi
if [ "$here" != "$folder" ]; then
    mkdir -p "$prefix/lib"
    rm -rf "$folder.new"
    cp -a "$here" "$folder.new"
    rm -rf "$folder"
    mv "$folder.new" "$folder"
fi
mkdir -p "$prefix/bin" "$prefix/share/applications" "$prefix/share/mime/packages" \\
    "$icons/scalable/apps" "$icons/256x256/apps"
for program in {" ".join(names.PROGRAMS)}; do
    ln -sf "$folder/$program" "$prefix/bin/$program"
done
while IFS= read -r line; do
    case $line in
        Exec=*) printf 'Exec="%s" %%f\\n' "$folder/{names.WINDOW_PROGRAM}" ;;
        TryExec=*) printf 'TryExec=%s\\n' "$folder/{names.WINDOW_PROGRAM}" ;;
        *) printf '%s\\n' "$line" ;;
    esac
done < "$folder/share/{names.COMMAND_LINE_PROGRAM}.desktop" > "$entry"
cp "$folder/share/{names.COMMAND_LINE_PROGRAM}.xml" "$type"
cp "$folder/share/{names.COMMAND_LINE_PROGRAM}.svg" "$drawing"
cp "$folder/share/{names.COMMAND_LINE_PROGRAM}.png" "$picture"
renew
echo "{names.PROGRAM_NAME} is installed in $folder."
echo "Start it from the menu or with $prefix/bin/{names.WINDOW_PROGRAM}."
"""
UNINSTALL_SCRIPT = f"""#!/bin/sh
# Removes the files that install.sh has installed in PREFIX; projects are kept.
set -eu
{SHELL_PATHS}
rm -f "$entry" "$type" "$drawing" "$picture"
for program in {" ".join(names.PROGRAMS)}; do
    if [ "$(readlink "$prefix/bin/$program")" = "$folder/$program" ]; then
        rm -f "$prefix/bin/$program"
    fi
done
if [ -x "$folder/{names.WINDOW_PROGRAM}" ]; then
    rm -rf "$folder"
fi
renew
echo "{names.PROGRAM_NAME} is removed from $prefix." \\
    "To remove its cache too, delete ~/.cache/lispac."
"""


def write_into(folder: Path) -> None:
    """Add the files for the Linux desktop to a finished bundle."""
    share = folder / "share"
    share.mkdir()
    (share / f"{names.COMMAND_LINE_PROGRAM}.desktop").write_text(
        DESKTOP_ENTRY.replace("@PROGRAM@", names.WINDOW_PROGRAM), encoding="utf-8"
    )
    (share / f"{names.COMMAND_LINE_PROGRAM}.xml").write_text(FILE_TYPE_XML, encoding="utf-8")
    for picture in (names.ICON_PNG, names.ICON_SVG):
        shutil.copy(picture, share / picture.name)
    for name, text in (("install.sh", INSTALL_SCRIPT), ("uninstall.sh", UNINSTALL_SCRIPT)):
        (folder / name).write_text(text, encoding="utf-8")
        (folder / name).chmod(0o755)
