"""What a result says, once for every way of showing it: verdict, checks, tables of cells.

The modules are imported one by one where they are needed, so that solving a drive on the command
line does not pay for trains and studies: `sheet` (what tables are), `words` (the verdict),
`drive_sheet`, `catalogue_sheets`, `document` (JSON). What sets it in lines, on a page or on paper
is `wraparc.render`.
"""
