"""Interfaces: results of computer vision: boxes, classes, detections."""
