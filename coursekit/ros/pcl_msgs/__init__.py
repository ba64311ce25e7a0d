"""Interfaces: point clouds as indices, models and meshes."""
