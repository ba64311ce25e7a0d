// Arithmetic of matrices, and what goes with it.
#pragma once
#include <chrono>

#include "opencv2/core/array.hpp"
#include "opencv2/core/pointer.hpp"

namespace cv
{
using remote::call;
using remote::kw;

#define COURSEKIT_OF_TWO(name) \
  inline void name(InputArray a, InputArray b, OutputArray dst, InputArray mask = noArray()) \
  { \
    dst.assign(call(#name, a, b, kw("mask", mask))); \
  }
COURSEKIT_OF_TWO(bitwise_and)
COURSEKIT_OF_TWO(bitwise_or)
COURSEKIT_OF_TWO(bitwise_xor)
#undef COURSEKIT_OF_TWO
inline void add(InputArray a, InputArray b, OutputArray dst, InputArray mask = noArray(), int dtype = -1)
{
  dst.assign(call("add", a, b, kw("mask", mask), kw("dtype", dtype)));
}
inline void subtract(InputArray a, InputArray b, OutputArray dst, InputArray mask = noArray(), int dtype = -1)
{
  dst.assign(call("subtract", a, b, kw("mask", mask), kw("dtype", dtype)));
}
inline void multiply(InputArray a, InputArray b, OutputArray dst, double scale = 1, int dtype = -1)
{
  dst.assign(call("multiply", a, b, kw("scale", scale), kw("dtype", dtype)));
}
inline void divide(InputArray a, InputArray b, OutputArray dst, double scale = 1, int dtype = -1)
{
  dst.assign(call("divide", a, b, kw("scale", scale), kw("dtype", dtype)));
}
inline void bitwise_not(InputArray src, OutputArray dst, InputArray mask = noArray())
{
  dst.assign(call("bitwise_not", src, kw("mask", mask)));
}
inline void absdiff(InputArray a, InputArray b, OutputArray dst) {dst.assign(call("absdiff", a, b));}
inline void max(InputArray a, InputArray b, OutputArray dst) {dst.assign(call("max", a, b));}
inline void min(InputArray a, InputArray b, OutputArray dst) {dst.assign(call("min", a, b));}
inline void compare(InputArray a, InputArray b, OutputArray dst, int how) {dst.assign(call("compare", a, b, how));}
inline void addWeighted(
  InputArray a, double alpha, InputArray b, double beta, double gamma, OutputArray dst, int dtype = -1)
{
  dst.assign(call("addWeighted", a, alpha, b, beta, gamma, kw("dtype", dtype)));
}
inline void convertScaleAbs(InputArray src, OutputArray dst, double alpha = 1, double beta = 0)
{
  dst.assign(call("convertScaleAbs", src, kw("alpha", alpha), kw("beta", beta)));
}
inline void inRange(InputArray src, InputArray low, InputArray high, OutputArray dst)
{
  dst.assign(call("inRange", src, low, high));
}
inline void normalize(
  InputArray src, InputOutputArray dst, double alpha = 1, double beta = 0, int norm_type = NORM_L2, int dtype = -1,
  InputArray mask = noArray())
{
  dst.assign(remote::call("normalize", src, src, alpha, beta, norm_type, dtype, mask));
}
inline void sqrt(InputArray src, OutputArray dst) {dst.assign(call("sqrt", src));}
inline void pow(InputArray src, double power, OutputArray dst) {dst.assign(call("pow", src, power));}
inline void LUT(InputArray src, InputArray table, OutputArray dst) {dst.assign(call("LUT", src, table));}

inline void flip(InputArray src, OutputArray dst, int code) {dst.assign(call("flip", src, code));}
inline void rotate(InputArray src, OutputArray dst, int code) {dst.assign(call("rotate", src, code));}
inline void transpose(InputArray src, OutputArray dst) {dst.assign(call("transpose", src));}
inline void repeat(InputArray src, int ny, int nx, OutputArray dst) {dst.assign(call("repeat", src, ny, nx));}
inline void hconcat(const std::vector<Mat> & all, OutputArray dst) {dst.assign(call("hconcat", all));}
inline void vconcat(const std::vector<Mat> & all, OutputArray dst) {dst.assign(call("vconcat", all));}
inline void hconcat(InputArray a, InputArray b, OutputArray dst) {hconcat({a.getMat(), b.getMat()}, dst);}
inline void vconcat(InputArray a, InputArray b, OutputArray dst) {vconcat({a.getMat(), b.getMat()}, dst);}
inline void hconcat(const Mat * all, size_t count, OutputArray dst) {hconcat(std::vector<Mat>(all, all + count), dst);}
inline void vconcat(const Mat * all, size_t count, OutputArray dst) {vconcat(std::vector<Mat>(all, all + count), dst);}
inline void copyMakeBorder(
  InputArray src, OutputArray dst, int top, int bottom, int left, int right, int border, const Scalar & value = Scalar())
{
  dst.assign(call("copyMakeBorder", src, top, bottom, left, right, border, kw("value", value)));
}
inline void split(InputArray src, OutputArray channels) {channels.assign(call("split", src));}
inline void split(const Mat & src, Mat * channels)
{
  remote::Value parts = call("split", src);
  for (size_t i = 0; i < parts.items.size(); ++i) {
    channels[i] = parts[i].mat;
  }
}
inline void merge(InputArray channels, OutputArray dst) {dst.assign(call("merge", channels));}
inline void merge(const Mat * channels, size_t count, OutputArray dst)
{
  merge(std::vector<Mat>(channels, channels + count), dst);
}
inline void extractChannel(InputArray src, OutputArray dst, int channel) {dst.assign(call("extractChannel", src, channel));}

namespace detail
{
inline Scalar scalar_of(const remote::Value & value)
{
  Scalar scalar;
  for (size_t i = 0; i < std::min<size_t>(value.items.size(), 4); ++i) {
    scalar[static_cast<int>(i)] = value[i].number();
  }
  return scalar;
}
inline Point point_of(const remote::Value & value)
{
  return {static_cast<int>(value[0].integer), static_cast<int>(value[1].integer)};
}
inline Rect rect_of(const remote::Value & v)
{
  Scalar s = scalar_of(v);
  return Rect(static_cast<int>(s[0]), static_cast<int>(s[1]), static_cast<int>(s[2]), static_cast<int>(s[3]));
}
inline RotatedRect rotated_of(const remote::Value & v)
{
  RotatedRect made;
  made.center = {static_cast<float>(v[0][0].number()), static_cast<float>(v[0][1].number())};
  made.size = {static_cast<float>(v[1][0].number()), static_cast<float>(v[1][1].number())};
  made.angle = static_cast<float>(v[2].number());
  return made;
}
}  // namespace detail

inline Scalar mean(InputArray src, InputArray mask = noArray())
{
  return detail::scalar_of(call("mean", src, kw("mask", mask)));
}
inline Scalar sum(InputArray src) {return detail::scalar_of(call("sumElems", src));}
inline void meanStdDev(InputArray src, OutputArray mean, OutputArray deviation, InputArray mask = noArray())
{
  remote::Value both = call("meanStdDev", src, kw("mask", mask));
  mean.assign(both[0]);
  deviation.assign(both[1]);
}
inline int countNonZero(InputArray src) {return static_cast<int>(call("countNonZero", src).integer);}
/// The places of all pixels that are not 0.
inline void findNonZero(InputArray src, OutputArray places) {places.assign(call("findNonZero", src));}
inline double norm(InputArray src, int kind = NORM_L2) {return call("norm", src, kind).number();}
inline double norm(InputArray a, InputArray b, int kind = NORM_L2) {return call("norm", a, b, kind).number();}
inline void minMaxLoc(
  InputArray src, double * low, double * high = nullptr, Point * low_at = nullptr, Point * high_at = nullptr,
  InputArray mask = noArray())
{
  remote::Value found = call("minMaxLoc", src, kw("mask", mask));
  if (low) {*low = found[0].number();}
  if (high) {*high = found[1].number();}
  if (low_at) {*low_at = detail::point_of(found[2]);}
  if (high_at) {*high_at = detail::point_of(found[3]);}
}

// -- operators

#define COURSEKIT_OPERATOR(sign, function) \
  inline Mat operator sign(const Mat & a, const Mat & b) \
  { \
    Mat made; \
    function(a, b, made); \
    return made; \
  } \
  inline Mat operator sign(const Mat & a, const Scalar & b) \
  { \
    Mat made; \
    function(a, b, made); \
    return made; \
  }
COURSEKIT_OPERATOR(+, add)
COURSEKIT_OPERATOR(-, subtract)
COURSEKIT_OPERATOR(&, bitwise_and)
COURSEKIT_OPERATOR(|, bitwise_or)
COURSEKIT_OPERATOR(^, bitwise_xor)
#undef COURSEKIT_OPERATOR
inline Mat operator~(const Mat & a)
{
  Mat made;
  bitwise_not(a, made);
  return made;
}
inline Mat operator*(const Mat & a, double by)
{
  Mat made;
  a.convertTo(made, -1, by);
  return made;
}
inline Mat operator*(double by, const Mat & a) {return a * by;}
inline Mat operator/(const Mat & a, double by) {return a * (1 / by);}
inline Mat operator*(const Mat & a, const Mat & b) {return call("gemm", a, b, 1.0, Mat(), 0.0).mat;}
inline Mat operator-(const Scalar & a, const Mat & b)
{
  Mat made;
  subtract(a, b, made);
  return made;
}
#define COURSEKIT_COMPARISON(sign, how) \
  inline Mat operator sign(const Mat & a, const Mat & b) {return call("compare", a, b, static_cast<int>(how)).mat;} \
  inline Mat operator sign(const Mat & a, double b) {return call("compare", a, b, static_cast<int>(how)).mat;}
COURSEKIT_COMPARISON(==, CMP_EQ)
COURSEKIT_COMPARISON(!=, CMP_NE)
COURSEKIT_COMPARISON(<, CMP_LT)
COURSEKIT_COMPARISON(<=, CMP_LE)
COURSEKIT_COMPARISON(>, CMP_GT)
COURSEKIT_COMPARISON(>=, CMP_GE)
#undef COURSEKIT_COMPARISON
inline Mat & operator+=(Mat & a, const Mat & b) {add(a, b, a); return a;}
inline Mat & operator-=(Mat & a, const Mat & b) {subtract(a, b, a); return a;}
inline Mat & operator+=(Mat & a, const Scalar & b) {add(a, b, a); return a;}
inline Mat & operator-=(Mat & a, const Scalar & b) {subtract(a, b, a); return a;}
inline Mat & operator*=(Mat & a, double by) {a.convertTo(a, -1, by); return a;}
inline Mat & operator/=(Mat & a, double by) {a.convertTo(a, -1, 1 / by); return a;}

// -- the library and the computer

inline std::string getVersionString() {return CV_VERSION;}
inline int getNumThreads() {return 1;}
/// Not followed: OpenCV runs in the session.
inline void setNumThreads(int) {}
/// Call `body` with parts of a range: here with all of it, in this thread.
template<class F>
void parallel_for_(const Range & range, const F & body, double = -1)
{
  if (!range.empty()) {
    body(range);
  }
}

// -- time

inline int64_t getTickCount()
{
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline double getTickFrequency() {return 1e9;}
class TickMeter
{
public:
  void start() {start_ = getTickCount();}
  void stop()
  {
    if (start_) {
      sum_ += getTickCount() - start_;
      ++counter_;
      start_ = 0;
    }
  }
  void reset() {*this = TickMeter();}
  double getTimeSec() const {return static_cast<double>(sum_) / getTickFrequency();}
  double getTimeMilli() const {return getTimeSec() * 1e3;}
  int64_t getCounter() const {return counter_;}
  double getFPS() const {return sum_ ? static_cast<double>(counter_) / getTimeSec() : 0;}

private:
  int64_t start_ = 0, sum_ = 0, counter_ = 0;
};
}  // namespace cv
#include "opencv2/core/algebra.hpp"
#include "opencv2/core/orders.hpp"
#include "opencv2/core/persistence.hpp"
