# pluginlib: packages say which file describes the plugins in their libraries.

include_guard(GLOBAL)

function(pluginlib_export_plugin_description_file category file)
  if(IS_ABSOLUTE "${file}")
    message(FATAL_ERROR "pluginlib_export_plugin_description_file() was called with an absolute path, it must be a relative path")
  endif()
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    message(FATAL_ERROR "Given plugin description file '${CMAKE_CURRENT_SOURCE_DIR}/${file}' does not exist")
  endif()
  get_filename_component(folder "${file}" DIRECTORY)
  install(FILES "${file}" DESTINATION share/${PROJECT_NAME}/${folder})
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND_STRING PROPERTY COURSEKIT_PLUGINS_${category}
    "share/${PROJECT_NAME}/${file}\n")
  get_property(content DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY COURSEKIT_PLUGINS_${category})
  ament_index_register_resource(${category}__pluginlib__plugin CONTENT "${content}")
endfunction()
