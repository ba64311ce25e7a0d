"""intra_process_demo: messages between nodes of one process."""
