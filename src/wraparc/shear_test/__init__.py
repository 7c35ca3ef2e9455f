"""Shear tests to a lagging: machine exports, friction curves, law, pressure dependence."""
