// Numbers of a matrix that are sorted, mixed and taken apart: SVD and PCA among it.
#pragma once
#include <cfloat>

#include "opencv2/core.hpp"

namespace cv
{
inline void sort(InputArray src, OutputArray dst, int flags) {dst.assign(call("sort", src, flags));}
inline void sortIdx(InputArray src, OutputArray dst, int flags) {dst.assign(call("sortIdx", src, flags));}
inline void insertChannel(InputArray src, InputOutputArray dst, int channel)
{
  dst.assign(call("insertChannel", src, dst, channel));
}
inline void patchNaNs(InputOutputArray src, double value = 0) {src.assign(call("patchNaNs", src, value));}
/// Whether all numbers are finite and within the limits; `pos` is the first that is not, and where not quiet, it throws.
inline bool checkRange(
  InputArray src, bool quiet = true, Point * pos = nullptr, double least = -DBL_MAX, double most = DBL_MAX)
{
  const auto answer = call("checkRange", src, kw("minVal", least), kw("maxVal", most));
  const bool within = answer[0].integer != 0;
  if (!within && pos) {
    *pos = detail::point_of(answer[1]);
  }
  if (!within && !quiet) {
    call("checkRange", src, kw("quiet", false), kw("minVal", least), kw("maxVal", most));
  }
  return within;
}
/// Pairs of channels, counted over all matrices: from one of src to one of dst.
inline void mixChannels(const Mat * src, size_t sources, Mat * dst, size_t targets, const int * pairs, size_t count)
{
  auto answer = call(
    "mixChannels", std::vector<Mat>(src, src + sources), std::vector<Mat>(dst, dst + targets),
    std::vector<int>(pairs, pairs + 2 * count));
  for (size_t i = 0; i < targets; ++i) {
    detail::put(dst[i], answer[i].mat);
  }
}
inline void mixChannels(const std::vector<Mat> & src, std::vector<Mat> & dst, const std::vector<int> & pairs)
{
  mixChannels(src.data(), src.size(), dst.data(), dst.size(), pairs.data(), pairs.size() / 2);
}
inline Mat abs(const Mat & a)
{
  Mat made;
  absdiff(a, Mat::zeros(a.size(), a.type()), made);
  return made;
}

/// A matrix as u, a diagonal w, and vt.
class SVD
{
public:
  enum Flags {MODIFY_A = 1, NO_UV = 2, FULL_UV = 4};
  Mat u, w, vt;
  SVD() = default;
  explicit SVD(InputArray src, int flags = 0) {(*this)(src, flags);}
  SVD & operator()(InputArray src, int flags = 0)
  {
    compute(src, w, u, vt, flags);
    return *this;
  }
  static void compute(InputArray src, OutputArray w, OutputArray u, OutputArray vt, int flags = 0)
  {
    auto answer = call("SVDecomp", src, kw("flags", flags));
    w.assign(answer[0]);
    u.assign(answer[1]);
    vt.assign(answer[2]);
  }
  static void compute(InputArray src, OutputArray w, int flags = 0) {compute(src, w, noArray(), noArray(), flags | NO_UV);}
  /// The direction that the matrix shortens most.
  static void solveZ(InputArray src, OutputArray dst)
  {
    const SVD parts(src, src.rows() >= src.cols() ? 0 : FULL_UV);
    dst.assign(parts.vt.row(parts.vt.rows - 1).t());
  }
};

/// The directions in which rows of numbers differ most.
class PCA
{
public:
  enum Flags {DATA_AS_ROW = 0, DATA_AS_COL = 1, USE_AVG = 2};
  Mat eigenvectors, eigenvalues, mean;
  PCA() = default;
  PCA(InputArray data, InputArray mean_, int flags, int components = 0) {(*this)(data, mean_, flags, components);}
  /// As many directions as are needed for that part of the variance, above 0 and up to 1.
  PCA(InputArray data, InputArray mean_, int flags, double variance) {(*this)(data, mean_, flags, variance);}
  PCA & operator()(InputArray data, InputArray mean_, int flags, int components = 0)
  {
    return compute(data, mean_, flags, "maxComponents", components);
  }
  PCA & operator()(InputArray data, InputArray mean_, int flags, double variance)
  {
    return compute(data, mean_, flags, "retainedVariance", variance);
  }
  Mat project(InputArray data) const
  {
    return rows_of(call("PCAProject", rows_of(data), rows_of(mean), eigenvectors).mat);
  }
  Mat backProject(InputArray data) const
  {
    return rows_of(call("PCABackProject", rows_of(data), rows_of(mean), eigenvectors).mat);
  }

private:
  template<class T>
  PCA & compute(InputArray data, InputArray mean_, int flags, const char * limit, T value)
  {
    in_columns_ = flags & DATA_AS_COL;
    auto answer = call("PCACompute2", rows_of(data), rows_of(mean_), kw(limit, value));
    mean = rows_of(answer[0].mat);
    eigenvectors = answer[1].mat;
    eigenvalues = answer[2].mat;
    return *this;
  }
  Mat rows_of(InputArray data) const
  {
    const Mat mat = data.getMat();
    return in_columns_ && !mat.empty() ? mat.t() : mat;
  }
  bool in_columns_ = false;
};
}  // namespace cv
