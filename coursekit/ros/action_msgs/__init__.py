"""Interfaces: goals, cancelling and status of actions."""
