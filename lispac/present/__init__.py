"""Results as values and tables, defined once for report, window, command line and JSON.

A module holds one kind of result: its rows as frozen dataclasses, whose field names are the keys of
all JSON and end with the unit of the value, and its tables, which are columns over these rows. To
add a column, add a field and a `tables.Column`.
"""
