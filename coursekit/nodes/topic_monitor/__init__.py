"""topic_monitor: the share of published messages that arrive."""
