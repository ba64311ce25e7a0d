"""Interfaces: what participants tell of their nodes."""
