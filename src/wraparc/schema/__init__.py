"""Documents of tables and keys, read with all their faults at once. Knows no belt."""
