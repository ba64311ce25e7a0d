# find_package() of a package that comes with coursekit: its config is two lines that set the name and include this file.

set(${_coursekit_name}_FOUND TRUE)
set(${_coursekit_name}_TARGETS ${_coursekit_name}::${_coursekit_name})
set(${_coursekit_name}_LIBRARIES ${_coursekit_name}::${_coursekit_name})
set(${_coursekit_name}_INCLUDE_DIRS "${COURSEKIT_ROOT}/include" "${COURSEKIT_CPP}/include")

foreach(_coursekit_suffix "" __rosidl_typesupport_cpp __rosidl_generator_cpp __rosidl_typesupport_introspection_cpp __rosidl_generator_c)
  set(_coursekit_target ${_coursekit_name}::${_coursekit_name}${_coursekit_suffix})
  if(NOT TARGET ${_coursekit_target})
    _add_library(${_coursekit_target} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${_coursekit_target} INTERFACE coursekit_headers)
  endif()
endforeach()

if(EXISTS "${COURSEKIT_CMAKE}/${_coursekit_name}.cmake")
  include("${COURSEKIT_CMAKE}/${_coursekit_name}.cmake")
endif()
