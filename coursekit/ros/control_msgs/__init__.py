"""Interfaces: commands to joints and grippers, and the state of their controllers."""
