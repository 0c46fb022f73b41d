"""Write the generated documents: the tables of the manual and the JSON schema of the report."""

from tests.documents import manual_tables, report_schema

report_schema.main()
manual_tables.main()
