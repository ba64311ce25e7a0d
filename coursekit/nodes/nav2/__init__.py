"""nav2's nodes beside its planners: the map server, the map saver, the lifecycle manager."""
