"""Measured drives: their records, the friction they tell, and what to watch in the field."""
