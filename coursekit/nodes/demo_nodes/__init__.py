"""demo_nodes_py: first nodes to run and read. demo_nodes_cpp's names run the same programs."""
