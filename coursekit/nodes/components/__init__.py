"""Containers: nodes that load components when asked. Here each component runs as a process of its own."""
