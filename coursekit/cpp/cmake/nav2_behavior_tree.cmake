# The engine loads the libraries of nodes that trees name.
target_link_libraries(nav2_behavior_tree::nav2_behavior_tree INTERFACE class_loader::class_loader)
