"""Planar scans from point clouds and depth images, and scan filters: numpy arrays in and out."""
