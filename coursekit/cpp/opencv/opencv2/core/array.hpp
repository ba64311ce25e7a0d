// InputArray, OutputArray and InputOutputArray: whatever a function takes and gives.
#pragma once
#include <array>

#include "coursekit/opencv/remote.hpp"

namespace cv
{
class _InputArray
{
public:
  _InputArray() = default;
  _InputArray(const Mat & mat)  // NOLINT: all of these are as OpenCV's
  : mat_(mat) {}
  _InputArray(const std::vector<Mat> & all)  // NOLINT
  : several_(true), all_(all) {}
  template<class T>
  _InputArray(const std::vector<T> & items)  // NOLINT
  : mat_(items) {}
  template<class T>
  _InputArray(const std::vector<std::vector<T>> & lists)  // NOLINT
  : several_(true)
  {
    for (auto & items : lists) {
      all_.emplace_back(items);
    }
  }
  template<class T, size_t n>
  _InputArray(const T (& items)[n])  // NOLINT
  : mat_(static_cast<int>(n), 1, DataType<T>::type, const_cast<T *>(items)) {}
  template<class T, size_t n>
  _InputArray(const std::array<T, n> & items)  // NOLINT
  : mat_(static_cast<int>(n), 1, DataType<T>::type, const_cast<T *>(items.data())) {}
  _InputArray(const Scalar & value)  // NOLINT
  : scalar_(true), value_(value) {}
  template<class T, int n>
  _InputArray(const Vec<T, n> & v)  // NOLINT
  : mat_(v) {}
  template<class T, int m, int n>
  _InputArray(const Matx<T, m, n> & small)  // NOLINT
  : mat_(small) {}
  _InputArray(double value)  // NOLINT
  : scalar_(true), value_(value) {}
  Mat getMat(int i = -1) const {return i < 0 ? mat_ : all_.at(static_cast<size_t>(i));}
  bool empty() const {return several_ ? all_.empty() : !scalar_ && mat_.empty();}
  int count() const {return static_cast<int>(all_.size());}
  bool isMat() const {return !several_ && !scalar_;}
  int type() const {return mat_.type();}
  int channels() const {return mat_.channels();}
  int depth() const {return mat_.depth();}
  int rows() const {return mat_.rows;}
  int cols() const {return mat_.cols;}
  Size size() const {return mat_.size();}
  void pack(coursekit::Packer & to) const
  {
    if (several_) {
      remote::pack(to, all_);
    } else if (scalar_) {
      remote::pack(to, value_);
    } else {
      remote::pack(to, mat_);
    }
  }

private:
  bool several_ = false, scalar_ = false;
  Mat mat_;
  std::vector<Mat> all_;
  Scalar value_;
};

namespace detail
{
/// What came back as a vector of numbers, points, ...: all numbers, in order.
template<class T>
void fill(std::vector<T> & items, const remote::Value & value)
{
  using Kind = DataType<T>;
  Mat whole = value.mat;
  if (!whole.empty() && whole.depth() != Kind::depth) {
    whole.convertTo(whole, Kind::depth);
  }
  items.resize(whole.total() * static_cast<size_t>(whole.channels()) / Kind::channels);
  if (!items.empty()) {
    std::memcpy(static_cast<void *>(items.data()), whole.data, items.size() * sizeof(T));
  }
}
template<class T>
void fill(std::vector<std::vector<T>> & lists, const remote::Value & value)
{
  lists.resize(value.items.size());
  for (size_t i = 0; i < lists.size(); ++i) {
    fill(lists[i], value.items[i]);
  }
}
/// The same for as many numbers as the compiler knows; nothing came back where what was asked for is not there.
template<class T>
void fill(T * numbers, size_t count, const remote::Value & value)
{
  std::vector<T> all;
  fill(all, value);
  CV_Assert(all.empty() || all.size() == count);
  std::copy(all.begin(), all.end(), numbers);
}
inline void fill(std::vector<Mat> & all, const remote::Value & value)
{
  all.clear();
  for (auto & item : value.items) {
    all.push_back(item.mat);
  }
}
/// A result goes into the memory that is there where it fits, so that a part of an image is written through.
inline void put(Mat & to, const Mat & result)
{
  if (to.data && to.rows == result.rows && to.cols == result.cols && to.type() == result.type()) {
    result.copyTo(to);
  } else {
    to = result;
  }
}
}  // namespace detail

class _OutputArray
{
public:
  using Set = std::function<void (const remote::Value &)>;
  _OutputArray() = default;
  _OutputArray(Mat & mat)  // NOLINT
  : mat_(&mat) {}
  _OutputArray(const Mat & part)  // NOLINT: a part of an image, as img(rect)
  : part_(part) {}
  template<class T>
  _OutputArray(std::vector<T> & items)  // NOLINT
  : set_([&items](const remote::Value & value) {detail::fill(items, value);}) {}
  template<class T, int n>
  _OutputArray(Vec<T, n> & v)  // NOLINT
  : part_(v), set_([&v](const remote::Value & value) {detail::fill(v.val, n, value);}) {}
  template<class T, int m, int n>
  _OutputArray(Matx<T, m, n> & small)  // NOLINT
  : part_(small), set_([&small](const remote::Value & value) {detail::fill(small.val, m * n, value);}) {}
  void assign(const remote::Value & value) const
  {
    if (set_) {
      set_(value);
    } else if (mat_) {
      detail::put(*mat_, value.mat);
    } else if (!part_.empty()) {
      detail::put(part_, value.mat);
    }
  }
  void assign(const Mat & mat) const
  {
    remote::Value value;
    value.mat = mat;
    assign(value);
  }
  bool needed() const {return set_ || mat_ || !part_.empty();}
  Mat getMat() const {return mat_ ? *mat_ : part_;}
  void create(Size size, int type) const {create(size.height, size.width, type);}
  void create(int rows, int cols, int type) const
  {
    if (mat_) {
      mat_->create(rows, cols, type);
    }
  }

protected:
  mutable Mat part_;

private:
  Mat * mat_ = nullptr;
  Set set_;
};
class _InputOutputArray : public _OutputArray
{
public:
  using _OutputArray::_OutputArray;
  template<class T>
  _InputOutputArray(std::vector<T> & items)  // NOLINT
  : _OutputArray(items) {part_ = Mat(items);}
  template<class T>
  _InputOutputArray(std::vector<std::vector<T>> & lists)  // NOLINT
  : _OutputArray(lists) {}
  _InputOutputArray(std::vector<Mat> & all)  // NOLINT
  : _OutputArray(all) {}
};

using InputArray = const _InputArray &;
using OutputArray = const _OutputArray &;
using InputOutputArray = const _InputOutputArray &;
using InputArrayOfArrays = InputArray;
using OutputArrayOfArrays = OutputArray;
/// In place of an array that is not wanted.
struct NoArray
{
  operator _InputArray() const {return {};}
  operator _OutputArray() const {return {};}
  operator _InputOutputArray() const {return {};}
};
inline NoArray noArray() {return {};}

inline void pack(coursekit::Packer & to, const _InputArray & array) {array.pack(to);}
inline void pack(coursekit::Packer & to, const _OutputArray & array) {remote::pack(to, array.getMat());}
}  // namespace cv
