# generate_parameter_library: a YAML file of parameters becomes a header with a struct of their values, and a listener.

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

# Tests whose programs are given a file with values of parameters.
foreach(_coursekit_kind gtest gmock)
  cmake_language(EVAL CODE "macro(add_rostest_with_parameters_${_coursekit_kind} name source file)
    _coursekit_gtest_program(\${name} ${_coursekit_kind} \${source} SKIP_LINKING_MAIN_LIBRARIES)
    _coursekit_gtest_test(\${name} ${_coursekit_kind} ARGS --ros-args --params-file \"\${file}\" --)
  endmacro()")
endforeach()
