// Images in files and in memory.
#pragma once
#include "opencv2/core.hpp"

namespace cv
{
/// The image in a file; an empty one where there is none.
inline Mat imread(const std::string & path, int flags = IMREAD_COLOR) {return call("imread", path, flags).mat;}
inline bool imwrite(const std::string & path, InputArray image, const std::vector<int> & params = {})
{
  return call("imwrite", path, image, kw("params", params)).integer != 0;
}
inline bool imencode(
  const std::string & kind, InputArray image, std::vector<uchar> & bytes, const std::vector<int> & params = {})
{
  remote::Value found = call("imencode", kind, image, kw("params", params));
  detail::fill(bytes, found[1]);
  return found[0].integer != 0;
}
inline Mat imdecode(InputArray bytes, int flags) {return call("imdecode", bytes, flags).mat;}
}  // namespace cv
