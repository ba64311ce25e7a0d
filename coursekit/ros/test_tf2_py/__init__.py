"""The name under which tf2_py's own tests import the binding."""
