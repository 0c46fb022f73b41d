"""Results as values and tables, defined once for report, window, command line and JSON.

A module contains one kind of result: its values as frozen dataclasses and its tables, whose columns
refer to fields of these dataclasses. The names of the fields are the keys of all JSON and end with
the unit of the value. To add a column, add a field and a `tables.Column`.
"""
