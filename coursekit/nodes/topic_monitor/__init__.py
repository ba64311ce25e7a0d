"""topic_monitor: how much of what is published arrives."""
