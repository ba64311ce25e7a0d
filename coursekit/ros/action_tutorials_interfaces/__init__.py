"""Interfaces: the action of the action tutorial."""
