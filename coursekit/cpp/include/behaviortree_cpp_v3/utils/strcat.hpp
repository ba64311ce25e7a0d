// Texts in a row.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/utils/string_view.hpp"

namespace BT
{
template<class ... Texts>
std::string StrCat(const Texts & ... texts)
{
  std::string whole;
  (whole.append(nonstd::string_view(texts)), ...);
  return whole;
}
template<class ... Texts>
void StrAppend(std::string * to, const Texts & ... texts) {to->append(StrCat(texts ...));}
}  // namespace BT
