"""Choose lagging, belt and take-up: candidates, limits, cost, ranking; and what if."""
