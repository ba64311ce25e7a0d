# Packages NAME_vendor: they bring a library that is the system's, or the student's wheel of it.

# One that CMake finds by its own config; without it the command that brings it is named.
macro(_coursekit_vendor library debian)
  find_package(${library} QUIET)
  if(NOT ${library}_FOUND)
    message(FATAL_ERROR "${_coursekit_name}: ${library} is not here: sudo apt install ${debian}")
  endif()
endmacro()
