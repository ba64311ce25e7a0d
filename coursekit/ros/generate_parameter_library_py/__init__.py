"""YAML files of parameters become Python modules: what `setup.py` files call, and what the modules import.

In ROS 2: the package generate_parameter_library_py.
"""
