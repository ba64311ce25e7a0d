"""Mapping and localisation under slam_toolbox's names: the nodes, their parameters, topics and services."""
