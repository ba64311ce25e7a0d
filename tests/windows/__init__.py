"""The tests and the chapters on Windows' own Python under Wine: `python -m tests.windows`, or `make windows`."""
