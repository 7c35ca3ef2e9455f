"""Results in words and tables, once for every way of showing them.

The modules are imported one by one where they are needed, so that solving a drive on the command
line does not pay for notebooks and JSON: `sheet` (what tables are), `words` (the verdict),
`drive_sheet`, `catalogue_sheets`, `document` (JSON), `profile_csv`, `notebook` (HTML, frames).
"""
