"""intra_process_demo: messages between nodes in one process."""
