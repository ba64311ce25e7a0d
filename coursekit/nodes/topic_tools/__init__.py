"""topic_tools: programs that republish messages of any type."""
