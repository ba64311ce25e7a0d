"""Planar scans out of clouds and depth images, and filters of scans: numpy arrays in and out."""
