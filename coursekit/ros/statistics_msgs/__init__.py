"""Interfaces: statistics over windows of time."""
