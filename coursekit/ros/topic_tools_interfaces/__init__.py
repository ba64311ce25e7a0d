"""Interfaces of topic_tools_interfaces."""
