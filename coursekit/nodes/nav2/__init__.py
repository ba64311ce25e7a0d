"""What nav2 starts beside its planners: the map server, the map saver, the lifecycle manager."""
