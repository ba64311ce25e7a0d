"""The middleware: graph, names, QoS, topics, services, clocks and processes of one interpreter."""
