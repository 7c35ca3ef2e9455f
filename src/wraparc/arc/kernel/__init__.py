"""The numerical kernel of one wrap arc: plain floats and tuples, no objects."""
