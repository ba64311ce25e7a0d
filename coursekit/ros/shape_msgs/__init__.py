"""Interfaces: solids, meshes, planes."""
