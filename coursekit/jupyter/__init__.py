"""The layer between Jupyter and the lab: the course's kernel, and JupyterLab's settings for it."""
