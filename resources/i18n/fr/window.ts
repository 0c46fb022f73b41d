<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>panels</name>
    <message>
        <source>Targets by lines</source>
        <translation>Cibles par ligne</translation>
    </message>
    <message>
        <source>Workflow</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Language · &amp;Langue</source>
        <translation>&amp;Langue · Language</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>&amp;English</translation>
    </message>
    <message>
        <source>&amp;Français</source>
        <translation>&amp;Français</translation>
    </message>
    <message>
        <source>The window in English</source>
        <translation>La fenêtre en anglais</translation>
    </message>
    <message>
        <source>The window changes when the running task has ended</source>
        <translation>La fenêtre changera quand la tâche en cours sera terminée</translation>
    </message>
</context>
</TS>
