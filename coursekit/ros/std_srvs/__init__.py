"""Interfaces: services that need no data of their own."""
