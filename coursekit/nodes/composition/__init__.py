"""The package composition: nodes that run alone in a container, or all in one process."""
