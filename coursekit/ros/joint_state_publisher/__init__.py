"""The node that publishes joint states, under its package's name, for programs that derive from it."""
