"""Interfaces: goal status as actionlib had it."""
