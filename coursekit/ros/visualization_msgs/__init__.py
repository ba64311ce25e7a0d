"""Interfaces: markers to draw."""
