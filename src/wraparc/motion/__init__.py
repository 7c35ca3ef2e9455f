"""Drives in time: starting, stopping, and whether the second drive pulsates."""
