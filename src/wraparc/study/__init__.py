"""Many solves: batches, sampling, choice of designs, calibration."""
