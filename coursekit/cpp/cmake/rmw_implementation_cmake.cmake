# rmw_implementation_cmake: here is one middleware, so that what is done for each is done once.

macro(get_available_rmw_implementations variable)
  set(${variable} rmw_coursekit)
endmacro()

macro(get_default_rmw_implementation variable)
  set(${variable} rmw_coursekit)
endmacro()

macro(call_for_each_rmw_implementation _coursekit_name)
  set(rmw_implementation rmw_coursekit)
  set(target_suffix "")
  cmake_language(CALL ${_coursekit_name})
endmacro()
