"""Containers: nodes that load components on request. Here each component runs as its own process."""
