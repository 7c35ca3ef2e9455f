"""Tables out of the files of machines: numbers, columns, units, spreadsheets."""
