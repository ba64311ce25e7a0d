# Factories load the libraries of nodes that trees name.
target_link_libraries(behaviortree_cpp_v3::behaviortree_cpp_v3 INTERFACE class_loader::class_loader)

# The name that the library itself has for its target.
if(NOT TARGET BT::behaviortree_cpp_v3)
  _add_library(BT::behaviortree_cpp_v3 INTERFACE IMPORTED GLOBAL)
  target_link_libraries(BT::behaviortree_cpp_v3 INTERFACE behaviortree_cpp_v3::behaviortree_cpp_v3)
endif()

# A package with a library of tree nodes also gets a program that loads such libraries: bt_navigator starts it where a robot's
# would load them itself.
if(COURSEKIT_LOADS)
  cmake_language(DEFER DIRECTORY "${PROJECT_SOURCE_DIR}" CALL _coursekit_add_tree_nodes_program "${PROJECT_SOURCE_DIR}")
endif()

function(_coursekit_add_tree_nodes_program folder)
  _coursekit_has_tree_nodes("${folder}" has)
  if(NOT has OR TARGET __tree_nodes)
    return()
  endif()
  _coursekit_plugins_source(__tree_nodes source)
  add_executable(__tree_nodes "${source}")
  target_link_libraries(__tree_nodes PRIVATE class_loader::class_loader)
  install(TARGETS __tree_nodes DESTINATION lib/${PROJECT_NAME})
endfunction()

function(_coursekit_has_tree_nodes folder variable)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  set(has FALSE)
  foreach(target ${targets})
    get_property(definitions TARGET ${target} PROPERTY COMPILE_DEFINITIONS)
    if(TARGET ${target}__loadable AND "${definitions}" MATCHES "BT_PLUGIN_EXPORT")
      set(has TRUE)
    endif()
  endforeach()
  foreach(inner ${folders})
    _coursekit_has_tree_nodes("${inner}" inner_has)
    if(inner_has)
      set(has TRUE)
    endif()
  endforeach()
  set(${variable} ${has} PARENT_SCOPE)
endfunction()
