"""nav2's nodes other than its planners: the map server, the map saver, the lifecycle manager."""
