"""Interfaces: motions of joints over time."""
