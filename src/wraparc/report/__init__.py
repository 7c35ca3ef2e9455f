"""Documents that are kept: the report of shear tests, the calculation note."""
