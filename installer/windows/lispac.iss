; The installer for Windows, by Inno Setup 6. `python installer/bootstrap.py bundle` runs it; every name
; and the version come from build\bundle\names.iss, which that command writes.
#include "..\..\build\bundle\names.iss"

[Setup]
AppId={#AppIdentifier}
AppName={#AppName}
AppVersion={#AppVersion}
AppVerName={#AppName} {#AppVersion}
AppPublisher={#AppPublisher}
AppComments={#AppSummary}
DefaultDirName={autopf}\{#AppName}
DefaultGroupName={#AppName}
DisableProgramGroupPage=yes
; Without an administrator it installs for the user alone
PrivilegesRequired=lowest
PrivilegesRequiredOverridesAllowed=dialog
ArchitecturesAllowed=x64compatible
ArchitecturesInstallIn64BitMode=x64compatible
MinVersion=10.0.17763
LicenseFile=..\..\LICENSE
OutputDir=..\..\dist
OutputBaseFilename={#BundleName}
UninstallDisplayIcon={app}\{#Window}.exe
ChangesAssociations=yes
Compression=lzma2
SolidCompression=yes
WizardStyle=modern

[Languages]
Name: "english"; MessagesFile: "compiler:Default.isl"
Name: "french"; MessagesFile: "compiler:Languages\French.isl"

[CustomMessages]
english.Document={#Document}
french.Document={#DocumentFr}

[Tasks]
Name: "desktopicon"; Description: "{cm:CreateDesktopIcon}"; Flags: unchecked

[InstallDelete]
; What an older version had and this one has not
Type: filesandordirs; Name: "{app}\_internal"

[Files]
Source: "{#BundleFolder}\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion

[Icons]
Name: "{group}\{#AppName}"; Filename: "{app}\{#Window}.exe"
Name: "{autodesktop}\{#AppName}"; Filename: "{app}\{#Window}.exe"; Tasks: desktopicon

[Registry]
Root: HKA; Subkey: "Software\Classes\.{#Ending}"; ValueType: string; ValueData: "{#AppIdentifier}.project"; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\.{#Ending}"; ValueType: string; ValueName: "Content Type"; ValueData: "{#MimeType}"; Flags: uninsdeletevalue
Root: HKA; Subkey: "Software\Classes\{#AppIdentifier}.project"; ValueType: string; ValueData: "{cm:Document}"; Flags: uninsdeletekey
Root: HKA; Subkey: "Software\Classes\{#AppIdentifier}.project\DefaultIcon"; ValueType: string; ValueData: "{app}\{#Window}.exe,0"
Root: HKA; Subkey: "Software\Classes\{#AppIdentifier}.project\shell\open\command"; ValueType: string; ValueData: """{app}\{#Window}.exe"" ""%1"""
; `lispac` under Run, and `start lispac` in a terminal
Root: HKA; Subkey: "Software\Microsoft\Windows\CurrentVersion\App Paths\{#CommandLine}.exe"; ValueType: string; ValueData: "{app}\{#CommandLine}.exe"; Flags: uninsdeletekey

[Run]
Filename: "{app}\{#Window}.exe"; Description: "{cm:LaunchProgram,{#AppName}}"; Flags: nowait postinstall skipifsilent
