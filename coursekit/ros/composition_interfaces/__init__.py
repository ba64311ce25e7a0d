"""Interfaces: components loaded into a running container."""
