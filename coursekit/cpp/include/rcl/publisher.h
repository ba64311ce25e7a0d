// What C's functions tell of a publisher; its handle is what has its number.
#pragma once
#include "coursekit/entity.hpp"

using rcl_publisher_t = coursekit::Entity;
using rmw_publisher_t = rcl_publisher_t;

inline rmw_publisher_t * rcl_publisher_get_rmw_handle(const rcl_publisher_t * publisher)
{
  return const_cast<rmw_publisher_t *>(publisher);
}
inline bool rcl_publisher_is_valid(const rcl_publisher_t * publisher) {return publisher && publisher->id;}
