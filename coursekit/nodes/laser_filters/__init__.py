"""laser_filters: applies a chain of filters to a scan."""
