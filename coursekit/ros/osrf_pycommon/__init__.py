"""What launch's programs take from osrf_pycommon."""
