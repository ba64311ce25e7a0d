"""Interfaces: entities of a simulated world."""
