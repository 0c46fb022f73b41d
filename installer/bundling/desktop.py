"""Desktop entry, file type and the scripts that install and remove a bundle on Linux."""

from __future__ import annotations

import shutil
from pathlib import Path

from bundling import names

DESKTOP_ENTRY = f"""[Desktop Entry]
Type=Application
Name={names.NAME}
GenericName=LiDAR boresight calibration
GenericName[fr]=Étalonnage d'un LiDAR
Comment={names.SUMMARY}
Comment[fr]={names.SUMMARY_FR}
Exec=@PROGRAM@ %f
TryExec=@PROGRAM@
Icon={names.COMMAND_LINE}
Terminal=false
Categories=Science;Geoscience;
Keywords=LiDAR;boresight;hydrography;INS;GNSS;
MimeType={names.MIME_TYPE};
StartupWMClass={names.WINDOW}
"""
FILE_TYPE = f"""<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="{names.MIME_TYPE}">
    <comment>{names.DOCUMENT}</comment>
    <comment xml:lang="fr">{names.DOCUMENT_FR}</comment>
    <icon name="{names.COMMAND_LINE}"/>
    <glob pattern="*.{names.ENDING}"/>
  </mime-type>
</mime-info>
"""
PLACES = f"""here=$(cd "$(dirname "$0")" && pwd -P)
prefix=${{1:-${{HOME:?}}/.local}}
case $prefix in
    -*) echo "usage: $0 [PREFIX]  (default: ~/.local; all users, as root: /usr/local)"; exit 2 ;;
    /*) ;;
    *) echo "$prefix is not an absolute path. Give one, for example /usr/local." >&2; exit 2 ;;
esac
folder=$prefix/lib/{names.COMMAND_LINE}
entry=$prefix/share/applications/{names.COMMAND_LINE}.desktop
type=$prefix/share/mime/packages/{names.COMMAND_LINE}.xml
icons=$prefix/share/icons/hicolor
drawing=$icons/scalable/apps/{names.COMMAND_LINE}.svg
picture=$icons/256x256/apps/{names.COMMAND_LINE}.png
renew() {{
    # What a desktop does not have, it does not need
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
INSTALL = f"""#!/bin/sh
# Copies {names.NAME} to PREFIX/lib, with menu entry, icon and file type; links to it in PREFIX/bin.
set -eu
{PLACES}
if [ -e "$folder" ] && [ ! -x "$folder/{names.WINDOW}" ]; then
    echo "$folder exists but does not contain {names.NAME}. Move it, then start again." >&2
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
        Exec=*) printf 'Exec="%s" %%f\\n' "$folder/{names.WINDOW}" ;;
        TryExec=*) printf 'TryExec=%s\\n' "$folder/{names.WINDOW}" ;;
        *) printf '%s\\n' "$line" ;;
    esac
done < "$folder/share/{names.COMMAND_LINE}.desktop" > "$entry"
cp "$folder/share/{names.COMMAND_LINE}.xml" "$type"
cp "$folder/share/{names.COMMAND_LINE}.svg" "$drawing"
cp "$folder/share/{names.COMMAND_LINE}.png" "$picture"
renew
echo "{names.NAME} is installed in $folder."
echo "Start it from the menu or with $prefix/bin/{names.WINDOW}."
"""
UNINSTALL = f"""#!/bin/sh
# Removes the files that install.sh has installed in PREFIX; projects are kept.
set -eu
{PLACES}
rm -f "$entry" "$type" "$drawing" "$picture"
for program in {" ".join(names.PROGRAMS)}; do
    if [ "$(readlink "$prefix/bin/$program")" = "$folder/$program" ]; then
        rm -f "$prefix/bin/$program"
    fi
done
if [ -x "$folder/{names.WINDOW}" ]; then
    rm -rf "$folder"
fi
renew
echo "{names.NAME} is removed from $prefix. To remove its cache too, delete ~/.cache/lispac."
"""


def write_into(folder: Path) -> None:
    """Add the files for the Linux desktop to a finished bundle."""
    share = folder / "share"
    share.mkdir()
    (share / f"{names.COMMAND_LINE}.desktop").write_text(
        DESKTOP_ENTRY.replace("@PROGRAM@", names.WINDOW), encoding="utf-8"
    )
    (share / f"{names.COMMAND_LINE}.xml").write_text(FILE_TYPE, encoding="utf-8")
    for picture in (names.ICON, names.ICON_DRAWING):
        shutil.copy(picture, share / picture.name)
    for name, text in (("install.sh", INSTALL), ("uninstall.sh", UNINSTALL)):
        (folder / name).write_text(text, encoding="utf-8")
        (folder / name).chmod(0o755)
