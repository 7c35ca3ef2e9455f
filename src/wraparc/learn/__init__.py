"""A drive learned from the trend logs of its control system: zero, creep curve, friction, alarm."""
