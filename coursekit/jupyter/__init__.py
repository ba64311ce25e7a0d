"""The parts between Jupyter and the lab: the kernel of the course, and JupyterLab's settings for it."""
