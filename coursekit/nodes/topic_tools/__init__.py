"""topic_tools: messages of any type handed on."""
