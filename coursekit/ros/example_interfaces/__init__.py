"""Interfaces: interfaces to learn with."""
