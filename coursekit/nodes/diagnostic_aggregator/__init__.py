"""diagnostic_aggregator: the statuses of a robot's parts, put together in groups."""
