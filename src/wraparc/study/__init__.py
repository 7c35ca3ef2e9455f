"""Many variants of one drive: grids, draws, sensitivities; solved in parts that are kept."""
