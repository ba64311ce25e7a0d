// Mat: an image or a matrix, whose memory is shared by all that are made of it.
#pragma once
#include <cstring>
#include <functional>
#include <memory>
#include <sstream>

#include "opencv2/core/constants.hpp"
#include "opencv2/core/exception.hpp"
#include "opencv2/core/matx.hpp"
#include "opencv2/core/types.hpp"

namespace cv
{
/// Bytes from one row to the next, and from one pixel to the next.
struct MatStep
{
  size_t p[2] = {0, 0};
  operator size_t() const {return p[0];}
  size_t operator[](int i) const {return p[i];}
};
struct MatSize
{
  int p[2] = {0, 0};
  Size operator()() const {return {p[1], p[0]};}
  int operator[](int i) const {return p[i];}
  int dims() const {return 2;}
  bool operator==(const MatSize & o) const {return p[0] == o.p[0] && p[1] == o.p[1];}
  bool operator!=(const MatSize & o) const {return !(*this == o);}
};

class Mat
{
public:
  static constexpr size_t AUTO_STEP = 0;
  Mat() = default;
  Mat(int rows_, int cols_, int type_) {create(rows_, cols_, type_);}
  Mat(Size size_, int type_) {create(size_.height, size_.width, type_);}
  Mat(int rows_, int cols_, int type_, const Scalar & value)
  : Mat(rows_, cols_, type_) {setTo(value);}
  Mat(Size size_, int type_, const Scalar & value)
  : Mat(size_, type_) {setTo(value);}
  /// A view of memory that somebody else keeps.
  Mat(int rows_, int cols_, int type_, void * memory, size_t step_ = AUTO_STEP)
  : type_(type_), data(static_cast<uchar *>(memory)) {shape(rows_, cols_, step_ ? step_ : cols_ * elemSize());}
  Mat(Size size_, int type_, void * memory, size_t step_ = AUTO_STEP)
  : Mat(size_.height, size_.width, type_, memory, step_) {}
  Mat(const Mat & whole, const Rect & part);
  Mat(const Mat & whole, const Range & of_rows, const Range & of_cols = Range::all());
  template<class T>
  explicit Mat(const std::vector<T> & items, bool copy_data = false)
  : Mat(static_cast<int>(items.size()), 1, DataType<T>::type, const_cast<T *>(items.data()))
  {
    if (copy_data) {
      *this = clone();
    }
  }

  template<class T, int m, int n>
  explicit Mat(const Matx<T, m, n> & small, bool = true)
  : Mat(m, n, DataType<T>::type) {std::memcpy(data, small.val, sizeof(small.val));}

  template<class T, int n>
  explicit Mat(const Vec<T, n> & v, bool = true)
  : Mat(n, 1, DataType<T>::type) {std::memcpy(data, v.val, sizeof(v.val));}
  static Mat zeros(int rows, int cols, int type) {return Mat(rows, cols, type, Scalar::all(0));}
  static Mat zeros(Size size, int type) {return Mat(size, type, Scalar::all(0));}
  static Mat ones(int rows, int cols, int type) {return Mat(rows, cols, type, Scalar(1));}
  static Mat ones(Size size, int type) {return Mat(size, type, Scalar(1));}
  static Mat eye(int rows, int cols, int type);
  static Mat eye(Size size, int type) {return eye(size.height, size.width, type);}

  void create(int rows_, int cols_, int type_);
  void create(Size size_, int type_) {create(size_.height, size_.width, type_);}
  void release() {*this = Mat();}
  Mat clone() const;
  void copyTo(Mat & to) const;
  /// Copy the pixels where a mask is not zero; a mask of as many channels has them copied one by one.
  void copyTo(Mat & to, const Mat & mask) const;
  void copyTo(Mat && part) const {copyTo(static_cast<Mat &>(part));}
  void copyTo(Mat && part, const Mat & mask) const {copyTo(static_cast<Mat &>(part), mask);}
  /// The same numbers in another depth, each times alpha, plus beta, rounded and clipped.
  void convertTo(Mat & to, int rtype, double alpha = 1, double beta = 0) const;
  Mat & setTo(const Scalar & value);
  Mat & setTo(const Scalar & value, const Mat & mask);
  Mat & operator=(const Scalar & value) {return setTo(value);}
  Mat reshape(int channels_, int rows_ = 0) const;
  Mat t() const;
  Mat inv(int how = DECOMP_LU) const;
  /// Number by number.
  Mat mul(const Mat & o, double scale = 1) const;
  double dot(const Mat & o) const;
  Mat cross(const Mat & o) const;
  /// Its diagonal as a column, a view of the same memory; d above it, or below.
  Mat diag(int d = 0) const;
  /// A square matrix with these numbers on its diagonal.
  static Mat diag(const Mat & numbers);
  template<class T, int n>
  operator Vec<T, n>() const
  {
    Vec<T, n> made;
    numbers_to(made.val, n);
    return made;
  }
  template<class T, int m, int n>
  operator Matx<T, m, n>() const
  {
    Matx<T, m, n> made;
    CV_Assert(rows == m && cols == n);
    numbers_to(made.val, m * n);
    return made;
  }

  Mat row(int y) const {return Mat(*this, Range(y, y + 1), Range::all());}
  Mat col(int x) const {return Mat(*this, Range::all(), Range(x, x + 1));}
  Mat rowRange(int from, int to) const {return Mat(*this, Range(from, to), Range::all());}
  Mat colRange(int from, int to) const {return Mat(*this, Range::all(), Range(from, to));}
  Mat operator()(const Rect & part) const {return Mat(*this, part);}
  Mat operator()(const Range & of_rows, const Range & of_cols) const {return Mat(*this, of_rows, of_cols);}

  int type() const {return type_;}
  int depth() const {return CV_MAT_DEPTH(type_);}
  int channels() const {return CV_MAT_CN(type_);}
  size_t elemSize1() const
  {
    static const size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 2};
    return sizes[depth()];
  }
  size_t elemSize() const {return elemSize1() * static_cast<size_t>(channels());}
  size_t step1(int i = 0) const {return step.p[i] / elemSize1();}
  size_t total() const {return static_cast<size_t>(rows) * static_cast<size_t>(cols);}
  bool empty() const {return !data || !total();}
  bool isContinuous() const {return rows <= 1 || step.p[0] == static_cast<size_t>(cols) * elemSize();}
  bool isSubmatrix() const {return memory_ && (data != memory_->data() || total() * elemSize() < memory_->size());}

  uchar * ptr(int y = 0) {return data + static_cast<size_t>(y) * step.p[0];}
  const uchar * ptr(int y = 0) const {return data + static_cast<size_t>(y) * step.p[0];}
  template<class T>
  T * ptr(int y = 0) {return reinterpret_cast<T *>(ptr(y));}
  template<class T>
  const T * ptr(int y = 0) const {return reinterpret_cast<const T *>(ptr(y));}
  template<class T>
  T * ptr(int y, int x) {return ptr<T>(y) + x;}
  template<class T>
  const T * ptr(int y, int x) const {return ptr<T>(y) + x;}
  template<class T>
  T & at(int y, int x) {return ptr<T>(y)[x];}
  template<class T>
  const T & at(int y, int x) const {return ptr<T>(y)[x];}
  template<class T>
  T & at(Point p) {return at<T>(p.y, p.x);}
  template<class T>
  const T & at(Point p) const {return at<T>(p.y, p.x);}
  template<class T>
  T & at(int i) {return rows == 1 ? at<T>(0, i) : at<T>(i / cols, i % cols);}
  template<class T>
  const T & at(int i) const {return const_cast<Mat *>(this)->at<T>(i);}
  template<class T>
  class Iterator;
  template<class T>
  Iterator<T> begin() {return {this, 0};}
  template<class T>
  Iterator<T> end() {return {this, static_cast<int>(total())};}
  template<class T>
  Iterator<const T> begin() const {return {this, 0};}
  template<class T>
  Iterator<const T> end() const {return {this, static_cast<int>(total())};}
  template<class T, class F>
  void forEach(const F & visit)
  {
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < cols; ++x) {
        const int place[] = {y, x};
        visit(at<T>(y, x), place);
      }
    }
  }
  void push_back(const Mat & more);
  /// More rows, or fewer; new ones are zero.
  void resize(size_t count)
  {
    Mat made = zeros(static_cast<int>(count), cols, type());
    const int kept = std::min(rows, made.rows);
    rowRange(0, kept).copyTo(made.rowRange(0, kept));
    *this = made;
  }
  template<class T>
  void push_back(const T & row_) {push_back(Mat(1, 1, DataType<T>::type, const_cast<T *>(&row_)));}

private:
  template<class T>
  void numbers_to(T * to, size_t count) const
  {
    Mat same;
    convertTo(same, DataType<T>::depth);
    CV_Assert(same.total() * static_cast<size_t>(same.channels()) == count);
    std::memcpy(to, same.data, count * sizeof(T));
  }
  void shape(int rows_, int cols_, size_t step_)
  {
    rows = size.p[0] = rows_;
    cols = size.p[1] = cols_;
    step.p[0] = step_;
    step.p[1] = elemSize();
    datastart = data;
    dataend = rows && cols ? data + static_cast<size_t>(rows - 1) * step.p[0] + static_cast<size_t>(cols) * elemSize() : data;
  }
  int type_ = 0;
  std::shared_ptr<std::vector<uchar>> memory_;

public:
  int dims = 2, rows = 0, cols = 0;
  uchar * data = nullptr;
  /// Where the pixels of the whole matrix begin and end, also where this is a part of it.
  const uchar * datastart = nullptr, * dataend = nullptr;
  MatStep step;
  MatSize size;
};

/// Goes from pixel to pixel, row by row; a const T only reads.
template<class T>
class Mat::Iterator
{
  using Of = std::conditional_t<std::is_const_v<T>, const Mat, Mat>;

public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = std::remove_const_t<T>;
  using difference_type = std::ptrdiff_t;
  using pointer = T *;
  using reference = T &;
  Iterator() = default;
  Iterator(Of * mat, difference_type at)
  : mat_(mat), at_(at) {}
  operator Iterator<const T>() const {return {mat_, at_};}
  T & operator*() const {return (*this)[0];}
  T * operator->() const {return &**this;}
  T & operator[](difference_type n) const
  {
    const int place = static_cast<int>(at_ + n);
    return mat_->template at<value_type>(place / mat_->cols, place % mat_->cols);
  }
  Iterator & operator++() {++at_; return *this;}
  Iterator & operator--() {--at_; return *this;}
  Iterator operator++(int) {Iterator old = *this; ++at_; return old;}
  Iterator operator--(int) {Iterator old = *this; --at_; return old;}
  Iterator & operator+=(difference_type n) {at_ += n; return *this;}
  Iterator & operator-=(difference_type n) {at_ -= n; return *this;}
  Iterator operator+(difference_type n) const {return {mat_, at_ + n};}
  Iterator operator-(difference_type n) const {return {mat_, at_ - n};}
  difference_type operator-(const Iterator & o) const {return at_ - o.at_;}
  bool operator==(const Iterator & o) const {return at_ == o.at_;}
  bool operator!=(const Iterator & o) const {return at_ != o.at_;}
  bool operator<(const Iterator & o) const {return at_ < o.at_;}
  bool operator>(const Iterator & o) const {return at_ > o.at_;}
  Point pos() const {return {static_cast<int>(at_) % mat_->cols, static_cast<int>(at_) / mat_->cols};}

private:
  Of * mat_ = nullptr;
  difference_type at_ = 0;
};
template<class T>
using MatIterator_ = Mat::Iterator<T>;
template<class T>
using MatConstIterator_ = Mat::Iterator<const T>;

/// A Mat whose type the compiler knows.
template<class T>
class Mat_ : public Mat
{
public:
  Mat_()
  : Mat(0, 0, DataType<T>::type) {}
  Mat_(int rows_, int cols_)
  : Mat(rows_, cols_, DataType<T>::type) {}
  Mat_(int rows_, int cols_, const T & value)
  : Mat(rows_, cols_, DataType<T>::type) {std::fill(begin(), end(), value);}
  Mat_(const Mat & other)  // NOLINT: as OpenCV's
  {
    if (other.type() == DataType<T>::type) {
      Mat::operator=(other);
    } else {
      other.convertTo(*this, DataType<T>::type);
    }
  }
  T & operator()(int y, int x) {return at<T>(y, x);}
  const T & operator()(int y, int x) const {return at<T>(y, x);}
  T * operator[](int y) {return ptr<T>(y);}
  Mat::Iterator<T> begin() {return Mat::begin<T>();}
  Mat::Iterator<T> end() {return Mat::end<T>();}
  Mat::Iterator<const T> begin() const {return Mat::begin<T>();}
  Mat::Iterator<const T> end() const {return Mat::end<T>();}
};
template<class T>
struct MatCommaInitializer_
{
  Mat_<T> mat;
  int at = 0;
  template<class U>
  MatCommaInitializer_ & operator,(U value)
  {
    mat.template at<T>(at / mat.cols, at % mat.cols) = static_cast<T>(value);
    ++at;
    return *this;
  }
  operator Mat() const {return mat;}
  operator Mat_<T>() const {return mat;}
};
template<class T, class U>
MatCommaInitializer_<T> operator<<(const Mat_<T> & mat, U value)
{
  MatCommaInitializer_<T> made{mat};
  made, value;
  return made;
}
using Mat1b = Mat_<uchar>;
using Mat3b = Mat_<Vec3b>;
using Mat1f = Mat_<float>;
using Mat1d = Mat_<double>;
}  // namespace cv

#include "opencv2/core/mat.inl.hpp"
