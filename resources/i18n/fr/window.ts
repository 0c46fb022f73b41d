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
</context>
</TS>
