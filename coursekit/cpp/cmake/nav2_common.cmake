# nav2_common: what Navigation 2's packages ask of the compiler.

macro(nav2_package)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    add_compile_options(-Wall -Wextra -Wpedantic -Werror -Wdeprecated -Wno-deprecated-declarations -fPIC)
  endif()
endmacro()
