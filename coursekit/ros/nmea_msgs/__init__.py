"""Interfaces: what receivers of satellite positions say."""
