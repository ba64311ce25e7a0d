// What is among the elements of a collection.
#pragma once
#include <algorithm>
#include <set>

namespace rsl
{
template<class C>
bool contains(const C & values, const typename C::value_type & value)
{
  return std::find(values.begin(), values.end(), value) != values.end();
}
template<class C>
bool is_unique(const C & values)
{
  return std::set<typename C::value_type>(values.begin(), values.end()).size() == values.size();
}
}  // namespace rsl
