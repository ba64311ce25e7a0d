"""demo_nodes_py: first nodes to run and read. The names of demo_nodes_cpp run the same programs."""
