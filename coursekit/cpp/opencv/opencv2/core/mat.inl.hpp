// Mat's longer functions.
#pragma once
#include "opencv2/core/mat.hpp"

namespace cv
{
namespace detail
{
/// Call `function` with a number of the type that a depth stands for.
template<class F>
void with_depth(int depth, F function)
{
  switch (depth) {
    case CV_8U: return function(uchar());
    case CV_8S: return function(schar());
    case CV_16U: return function(ushort());
    case CV_16S: return function(static_cast<int16_t>(0));
    case CV_32S: return function(int());
    case CV_32F: return function(float());
    default: return function(double());
  }
}
}  // namespace detail

inline Mat::Mat(const Mat & whole, const Range & of_rows, const Range & of_cols)
: type_(whole.type_), memory_(whole.memory_)
{
  Range ys = of_rows.start == INT32_MIN ? Range(0, whole.rows) : of_rows;
  Range xs = of_cols.start == INT32_MIN ? Range(0, whole.cols) : of_cols;
  CV_Assert(0 <= ys.start && ys.start <= ys.end && ys.end <= whole.rows);
  CV_Assert(0 <= xs.start && xs.start <= xs.end && xs.end <= whole.cols);
  data = whole.data + ys.start * whole.step.p[0] + xs.start * whole.elemSize();
  shape(ys.size(), xs.size(), whole.step.p[0]);
  datastart = whole.datastart;
  dataend = whole.dataend;
}
inline Mat::Mat(const Mat & whole, const Rect & roi)
: type_(whole.type_), memory_(whole.memory_)
{
  CV_Assert(0 <= roi.x && 0 <= roi.width && roi.x + roi.width <= whole.cols && 0 <= roi.y && 0 <= roi.height &&
    roi.y + roi.height <= whole.rows);
  data = whole.data + roi.y * whole.step.p[0] + roi.x * whole.elemSize();
  shape(roi.height, roi.width, whole.step.p[0]);
  datastart = whole.datastart;
  dataend = whole.dataend;
}
inline void Mat::create(int rows_, int cols_, int wanted)
{
  if (data && rows == rows_ && cols == cols_ && type_ == wanted) {
    return;
  }
  CV_Assert(rows_ >= 0 && cols_ >= 0);
  type_ = wanted;
  memory_ = std::make_shared<std::vector<uchar>>(static_cast<size_t>(rows_) * static_cast<size_t>(cols_) * elemSize());
  data = memory_->data();
  shape(rows_, cols_, static_cast<size_t>(cols_) * elemSize());
}
inline Mat Mat::clone() const
{
  Mat copy;
  copyTo(copy);
  return copy;
}
inline void Mat::copyTo(Mat & to) const
{
  if (empty()) {
    to.release();
    return;
  }
  Mat from = *this;  // `to` may be this very one
  to.create(rows, cols, type_);
  for (int y = 0; y < rows; ++y) {
    std::memmove(to.ptr(y), from.ptr(y), static_cast<size_t>(cols) * elemSize());
  }
}
inline void Mat::copyTo(Mat & to, const Mat & mask) const
{
  if (mask.empty()) {
    copyTo(to);
    return;
  }
  CV_Assert(mask.depth() == CV_8U && mask.rows == rows && mask.cols == cols);
  const size_t parts = static_cast<size_t>(mask.channels()), size = elemSize() / parts;
  CV_Assert(parts == 1 || mask.channels() == channels());
  if (to.rows != rows || to.cols != cols || to.type_ != type_) {
    to = zeros(rows, cols, type_);
  }
  for (int y = 0; y < rows; ++y) {
    for (size_t i = 0; i < static_cast<size_t>(cols) * parts; ++i) {
      if (mask.ptr(y)[i]) {
        std::memcpy(to.ptr(y) + i * size, ptr(y) + i * size, size);
      }
    }
  }
}
namespace detail
{
/// OpenCV scales in single precision what goes to 8 or 16 bits, comes from them, or is a float before and after.
inline bool scales_in_float(int from, int to)
{
  return to < CV_32S || (to != CV_64F && (from < CV_32S || (from == CV_32F && to == CV_32F)));
}
template<class T>
double scaled(T number, double alpha, double beta, bool in_float)
{
  if (!in_float) {
    return static_cast<double>(number) * alpha + beta;
  }
  const double by = static_cast<float>(alpha), more = static_cast<float>(beta);
  return static_cast<float>(static_cast<double>(static_cast<float>(number)) * by + more);
}
}  // namespace detail
inline void Mat::convertTo(Mat & to, int rtype, double alpha, double beta) const
{
  Mat from = *this, made(rows, cols, CV_MAKETYPE(rtype < 0 ? depth() : CV_MAT_DEPTH(rtype), channels()));
  const int width = cols * channels();
  const bool in_float = (alpha != 1 || beta != 0) && detail::scales_in_float(from.depth(), made.depth());
  detail::with_depth(
    from.depth(), [&](auto source) {
      detail::with_depth(
        made.depth(), [&](auto target) {
          for (int y = 0; y < from.rows; ++y) {
            auto * in = from.ptr<decltype(source)>(y);
            auto * out = made.ptr<decltype(target)>(y);
            for (int i = 0; i < width; ++i) {
              out[i] = saturate_cast<decltype(target)>(detail::scaled(in[i], alpha, beta, in_float));
            }
          }
        });
    });
  if (to.data && to.rows == made.rows && to.cols == made.cols && to.type_ == made.type_) {
    made.copyTo(to);  // into the memory that it shares
  } else {
    to = made;
  }
}
inline Mat & Mat::setTo(const Scalar & value, const Mat & mask)
{
  detail::with_depth(
    depth(), [&](auto kind) {
      using T = decltype(kind);
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < cols; ++x) {
          for (int c = 0; c < channels() && (mask.empty() || mask.ptr(y)[x]); ++c) {
            ptr<T>(y)[x * channels() + c] = saturate_cast<T>(value[c % 4]);
          }
        }
      }
    });
  return *this;
}
inline Mat & Mat::setTo(const Scalar & value) {return setTo(value, Mat());}
inline Mat Mat::eye(int rows, int cols, int type)
{
  Mat made = zeros(rows, cols, type);
  for (int i = 0; i < std::min(rows, cols); ++i) {
    made(Rect(i, i, 1, 1)).setTo(Scalar(1));
  }
  return made;
}
inline Mat Mat::reshape(int channels_, int rows_) const
{
  int cn = channels_ ? channels_ : channels();
  int numbers = static_cast<int>(total()) * channels();
  int new_rows = rows_ ? rows_ : rows;
  CV_Assert(isContinuous() && new_rows > 0 && numbers % (new_rows * cn) == 0);
  Mat made = *this;
  made.type_ = CV_MAKETYPE(depth(), cn);
  made.shape(new_rows, numbers / (new_rows * cn), static_cast<size_t>(numbers / new_rows) * elemSize1());
  return made;
}
inline Mat Mat::t() const
{
  Mat made(cols, rows, type_);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < cols; ++x) {
      std::memcpy(made.ptr(x) + y * elemSize(), ptr(y) + x * elemSize(), elemSize());
    }
  }
  return made;
}
inline void Mat::push_back(const Mat & more)
{
  if (empty()) {
    *this = more.clone();
    return;
  }
  CV_Assert(more.cols == cols && more.type_ == type_);
  Mat made(rows + more.rows, cols, type_);
  copyTo(made.rowRange(0, rows));
  more.copyTo(made.rowRange(rows, rows + more.rows));
  *this = made;
}

/// Numbers with a point have the digits that tell them apart: 8 as float, 16 as double, whatever the stream is set to.
inline std::ostream & operator<<(std::ostream & out, const Mat & mat)
{
  std::ostringstream text;
  text.precision(mat.depth() == CV_64F ? 16 : 8);
  text << "[";
  detail::with_depth(
    mat.depth(), [&](auto kind) {
      for (int y = 0; y < mat.rows; ++y) {
        text << (y ? ";\n " : "");
        for (int i = 0; i < mat.cols * mat.channels(); ++i) {
          text << (i ? ", " : "");
          if constexpr (sizeof(kind) == 1) {
            text.width(3);
          }
          text << +mat.ptr<decltype(kind)>(y)[i];
        }
      }
    });
  return out << text.str() << "]";
}
template<class T, int m, int n>
std::ostream & operator<<(std::ostream & out, const Matx<T, m, n> & small) {return out << Mat(small);}
template<class T>
std::ostream & operator<<(std::ostream & out, const std::vector<Point_<T>> & points) {return out << Mat(points);}
template<class T>
std::ostream & operator<<(std::ostream & out, const std::vector<Point3_<T>> & points) {return out << Mat(points);}
}  // namespace cv
