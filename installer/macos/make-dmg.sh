#!/bin/sh
# The disk image for macOS from the .app that PyInstaller has made; `python3 installer/bootstrap.py bundle`
# runs it. Every name and the version come from build/bundle/names.sh, which that command writes; file
# type, icon and identifier are in the .app already (installer/bundling/names.py, for_macos).
set -eu
checkout=$(cd "$(dirname "$0")/../.." && pwd -P)
. "$checkout/build/bundle/names.sh"

app=$checkout/build/bundle/dist/$AppName.app
image=$checkout/dist/$BundleName.dmg
staging=$checkout/build/bundle/dmg

for program in "$CommandLine" "$Window"; do
    [ -x "$app/Contents/MacOS/$program" ] || { echo "$app has no $program." >&2; exit 1; }
done
stated=$(/usr/libexec/PlistBuddy -c "Print :CFBundleShortVersionString" "$app/Contents/Info.plist")
[ "$stated" = "$AppVersion" ] || { echo "$app says it is version $stated, not $AppVersion." >&2; exit 1; }

# CODESIGN_IDENTITY is the maker's certificate; without it the seal is valid on this Mac only. The hardened
# runtime, which a notary asks for, loads only libraries of the same maker: without one, none at all.
if [ -n "${CODESIGN_IDENTITY:-}" ]; then
    codesign --force --deep --timestamp --options runtime \
        --entitlements "$checkout/installer/macos/entitlements.plist" --sign "$CODESIGN_IDENTITY" "$app"
else
    codesign --force --deep --sign - "$app"
fi

rm -rf "$staging"
mkdir -p "$staging"
cp -R "$app" "$staging/"
cp "$BundleFolder/LICENSES.txt" "$staging/"
ln -s /Applications "$staging/Applications"
rm -f "$image"
hdiutil create -volname "$AppName $AppVersion" -srcfolder "$staging" -format UDZO -ov "$image"
echo "$image"
