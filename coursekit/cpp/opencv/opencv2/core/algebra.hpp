// Matrices that are solved, inverted and taken apart, and numbers by chance.
#pragma once
#include "opencv2/core/array.hpp"

namespace cv
{
inline void setIdentity(InputOutputArray m, const Scalar & value = Scalar(1))
{
  Mat mat = m.getMat();
  Mat(Mat::eye(mat.rows, mat.cols, mat.type())).convertTo(mat, mat.type(), value[0]);
  m.assign(mat);
}
inline double invert(InputArray src, OutputArray dst, int how = DECOMP_LU)
{
  auto answer = call("invert", src, kw("flags", how));
  dst.assign(answer[1]);
  return answer[0].number();
}
inline Mat Mat::inv(int how) const
{
  Mat made;
  invert(*this, made, how);
  return made;
}
inline Mat Mat::mul(const Mat & o, double scale) const
{
  Mat made;
  multiply(*this, o, made, scale);
  return made;
}
inline double Mat::dot(const Mat & o) const
{
  Mat a, b;
  convertTo(a, CV_64F);
  o.convertTo(b, CV_64F);
  const auto products = sum(a.mul(b));
  return products[0] + products[1] + products[2] + products[3];
}
inline Mat Mat::cross(const Mat & o) const
{
  Mat made;
  Mat(Vec3d(*this).cross(Vec3d(o))).reshape(channels(), rows).convertTo(made, depth());
  return made;
}
inline Mat Mat::diag(int d) const
{
  const int y = std::max(-d, 0), x = std::max(d, 0), count = std::min(rows - y, cols - x);
  CV_Assert(count > 0);
  Mat made = *this;
  made.data += static_cast<size_t>(y) * step.p[0] + static_cast<size_t>(x) * elemSize();
  made.shape(count, 1, step.p[0] + elemSize());  // from one row to the next is also one pixel further
  made.datastart = datastart;
  made.dataend = dataend;
  return made;
}
inline Mat Mat::diag(const Mat & numbers)
{
  const int count = static_cast<int>(numbers.total());
  Mat made = zeros(count, count, numbers.type());
  for (int i = 0; i < count; ++i) {
    (numbers.rows == 1 ? numbers.col(i) : numbers.row(i)).copyTo(made(Rect(i, i, 1, 1)));
  }
  return made;
}
inline bool solve(InputArray a, InputArray b, OutputArray x, int how = DECOMP_LU)
{
  auto answer = call("solve", a, b, kw("flags", how));
  x.assign(answer[1]);
  return answer[0].integer != 0;
}
inline double determinant(InputArray m) {return call("determinant", m).number();}
inline Scalar trace(InputArray m)
{
  auto sums = call("trace", m);
  return Scalar(sums[0].number(), sums[1].number(), sums[2].number(), sums[3].number());
}
inline bool eigen(InputArray m, OutputArray values, OutputArray vectors = noArray())
{
  auto answer = call("eigen", m);
  values.assign(answer[1]);
  vectors.assign(answer[2]);
  return answer[0].integer != 0;
}
inline void gemm(InputArray a, InputArray b, double alpha, InputArray c, double beta, OutputArray dst, int flags = 0)
{
  dst.assign(call("gemm", a, b, alpha, c, beta, kw("flags", flags)));
}
inline void exp(InputArray src, OutputArray dst) {dst.assign(call("exp", src));}
inline void log(InputArray src, OutputArray dst) {dst.assign(call("log", src));}
inline void magnitude(InputArray x, InputArray y, OutputArray dst) {dst.assign(call("magnitude", x, y));}
inline void phase(InputArray x, InputArray y, OutputArray angle, bool degrees = false)
{
  angle.assign(call("phase", x, y, kw("angleInDegrees", degrees)));
}
inline void cartToPolar(InputArray x, InputArray y, OutputArray length, OutputArray angle, bool degrees = false)
{
  auto answer = call("cartToPolar", x, y, kw("angleInDegrees", degrees));
  length.assign(answer[0]);
  angle.assign(answer[1]);
}
inline void polarToCart(InputArray length, InputArray angle, OutputArray x, OutputArray y, bool degrees = false)
{
  auto answer = call("polarToCart", length, angle, kw("angleInDegrees", degrees));
  x.assign(answer[0]);
  y.assign(answer[1]);
}
inline void reduce(InputArray src, OutputArray dst, int dim, int how, int dtype = -1)
{
  dst.assign(call("reduce", src, dim, how, kw("dtype", dtype)));
}
inline void perspectiveTransform(InputArray src, OutputArray dst, InputArray m)
{
  dst.assign(call("perspectiveTransform", src, m));
}
inline void transform(InputArray src, OutputArray dst, InputArray m) {dst.assign(call("transform", src, m));}
inline void dft(InputArray src, OutputArray dst, int flags = 0, int rows = 0)
{
  dst.assign(call("dft", src, kw("flags", flags), kw("nonzeroRows", rows)));
}
inline void idft(InputArray src, OutputArray dst, int flags = 0, int rows = 0)
{
  dft(src, dst, flags | DFT_INVERSE, rows);
}
inline int getOptimalDFTSize(int size) {return static_cast<int>(call("getOptimalDFTSize", size).integer);}
/// Groups of rows of CV_32F that lie together; how far they are from their centres in all.
inline double kmeans(
  InputArray data, int groups, InputOutputArray labels, TermCriteria end, int attempts, int flags,
  OutputArray centers = noArray())
{
  auto answer = call("kmeans", data, groups, labels, end, attempts, flags);
  labels.assign(answer[1]);
  centers.assign(answer[2]);
  return answer[0].number();
}

/// Numbers by chance: the same after the same seed.
class RNG
{
public:
  enum {UNIFORM, NORMAL};
  uint64_t state;
  RNG(uint64_t seed = 0xffffffff)  // NOLINT: as OpenCV's
  : state(seed ? seed : 0xffffffff) {}
  unsigned next()
  {
    state = static_cast<uint64_t>(static_cast<uint32_t>(state)) * 4164903690U + (state >> 32);
    return static_cast<unsigned>(state);
  }
  operator int() {return static_cast<int>(next());}
  operator unsigned() {return next();}
  operator double() {return next() * 0x1p-32;}
  int uniform(int a, int b) {return a == b ? a : static_cast<int>(next() % static_cast<unsigned>(b - a)) + a;}
  float uniform(float a, float b) {return static_cast<float>(next() * 0x1p-32) * (b - a) + a;}
  double uniform(double a, double b)
  {
    uint64_t high = next();
    return static_cast<double>(high << 32 | next()) * 0x1p-64 * (b - a) + a;
  }
  double gaussian(double sigma)
  {
    double length = std::sqrt(-2 * std::log(1 - uniform(0.0, 1.0)));
    return sigma * length * std::cos(2 * CV_PI * uniform(0.0, 1.0));
  }
  void fill(InputOutputArray mat, int kind, InputArray a, InputArray b)
  {
    mat.assign(call(kind == UNIFORM ? "randu" : "randn", mat, a, b));
  }
};
inline RNG & theRNG()
{
  static thread_local RNG own;
  return own;
}
inline void setRNGSeed(int seed)
{
  theRNG() = RNG(static_cast<uint64_t>(seed));
  call("setRNGSeed", seed);
}
inline void randu(InputOutputArray dst, InputArray low, InputArray high) {dst.assign(call("randu", dst, low, high));}
inline void randn(InputOutputArray dst, InputArray mean, InputArray deviation)
{
  dst.assign(call("randn", dst, mean, deviation));
}
}  // namespace cv
