# Factories load the libraries of nodes that trees name.
target_link_libraries(behaviortree_cpp_v3::behaviortree_cpp_v3 INTERFACE class_loader::class_loader)

# The name that the library itself has for its target.
if(NOT TARGET BT::behaviortree_cpp_v3)
  _add_library(BT::behaviortree_cpp_v3 INTERFACE IMPORTED GLOBAL)
  target_link_libraries(BT::behaviortree_cpp_v3 INTERFACE behaviortree_cpp_v3::behaviortree_cpp_v3)
endif()
