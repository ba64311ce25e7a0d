"""What is between Jupyter and the lab: the kernel of the course, and what JupyterLab is told of it."""
