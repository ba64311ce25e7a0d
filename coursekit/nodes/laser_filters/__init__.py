"""laser_filters: a scan goes through filters, one after the other."""
