"""The node that publishes joint states, under the name of its package, for those who build on it."""
