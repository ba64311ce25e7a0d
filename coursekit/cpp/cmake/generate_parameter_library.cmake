# generate_parameter_library: a YAML file of parameters becomes a header, or a Python module, with a struct and a listener.

include_guard(GLOBAL)
find_package(fmt QUIET GLOBAL)

# The third word is a header with checks of the package's own. Both are found by their names, and below the package's.
function(generate_parameter_library target file)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}/include")
  set(checks "")
  if(ARGC GREATER 2)
    get_filename_component(checks "${ARGV2}" NAME)
    file(STRINGS "${CMAKE_CURRENT_SOURCE_DIR}/${ARGV2}" formats REGEX "include *[<\"]fmt/")
    if(formats AND NOT fmt_FOUND)
      message(FATAL_ERROR "generate_parameter_library: fmt is not here: sudo apt install libfmt-dev")
    endif()
    file(COPY "${CMAKE_CURRENT_SOURCE_DIR}/${ARGV2}" DESTINATION "${folder}")
    file(COPY "${CMAKE_CURRENT_SOURCE_DIR}/${ARGV2}" DESTINATION "${folder}/${PROJECT_NAME}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${ARGV2}")
  endif()
  set(header "${folder}/${PROJECT_NAME}/${target}.hpp")
  add_custom_command(OUTPUT "${header}"
    COMMAND "${COURSEKIT_PYTHON}" -m coursekit.packages.generate_parameters "${header}" "${CMAKE_CURRENT_SOURCE_DIR}/${file}" ${checks}
    DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${file}" VERBATIM)
  file(GENERATE OUTPUT "${folder}/${target}.hpp" CONTENT "#pragma once\n#include \"${PROJECT_NAME}/${target}.hpp\"\n")
  _add_library(${target} INTERFACE "${header}")
  target_include_directories(${target} INTERFACE "$<BUILD_INTERFACE:${folder}>" "$<INSTALL_INTERFACE:include>")
  target_link_libraries(${target} INTERFACE coursekit_headers $<TARGET_NAME_IF_EXISTS:fmt::fmt>)
  install(DIRECTORY "${folder}/" DESTINATION include)
endfunction()

# The Python module of such a file, in the package's own; the third word is a module with checks.
function(generate_parameter_module name file)
  set(module "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}/${name}.py")
  add_custom_command(OUTPUT "${module}"
    COMMAND "${COURSEKIT_PYTHON}" -m coursekit.packages.generate_parameters "${module}" "${CMAKE_CURRENT_SOURCE_DIR}/${file}" ${ARGN}
    DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${file}" VERBATIM)
  add_custom_target(${name} ALL DEPENDS "${module}")
  install(FILES "${module}" DESTINATION "${COURSEKIT_SITE_PACKAGES}/${PROJECT_NAME}")
endfunction()

# Tests whose programs are given a file with values of parameters.
foreach(_coursekit_kind gtest gmock)
  cmake_language(EVAL CODE "macro(add_rostest_with_parameters_${_coursekit_kind} name source file)
    _coursekit_gtest_program(\${name} ${_coursekit_kind} \${source} SKIP_LINKING_MAIN_LIBRARIES)
    _coursekit_gtest_test(\${name} ${_coursekit_kind} ARGS --ros-args --params-file \"\${file}\" --)
  endmacro()")
endforeach()
