# Factories load the libraries of nodes that trees name.
target_link_libraries(behaviortree_cpp_v3::behaviortree_cpp_v3 INTERFACE class_loader::class_loader)
