// What programs ask of the middleware itself.
#pragma once
#include "rmw/types.h"

/// How messages travel here.
inline const char * rmw_get_serialization_format() {return "cdr";}
inline const char * rmw_get_implementation_identifier() {return "rmw_fastrtps_cpp";}
