// How functions of OpenCV are answered: by Python's cv2 in the session, asked over the link.
// The Mat is the system's where it has OpenCV for C++, else the one in coursekit/cpp/opencv.
#pragma once
#include "coursekit/link.hpp"
#include "opencv2/core/mat.hpp"

namespace cv::remote
{
enum Kind {NONE, INTEGER, REAL, TEXT, MAT, LIST, TUPLE, KEYWORD};

/// What came back: a number, a text, a matrix, or several of these.
struct Value
{
  int64_t kind = NONE, integer = 0;
  double real = 0;
  std::string text;
  Mat mat;
  std::vector<Value> items;
  double number() const {return kind == REAL ? real : static_cast<double>(integer);}
  const Value & operator[](size_t i) const {return items.at(i);}
};

using coursekit::Packer;
using coursekit::Unpacker;

inline void pack(Packer & to, const Mat & mat)
{
  if (mat.empty()) {
    to.i(NONE);
    return;
  }
  size_t width = static_cast<size_t>(mat.cols) * mat.elemSize();
  to.i(MAT).i(mat.rows).i(mat.cols).i(mat.depth()).i(mat.channels()).i(static_cast<int64_t>(width * mat.rows));
  for (int y = 0; y < mat.rows; ++y) {
    to.raw(mat.ptr(y), width);
  }
}
inline void pack(Packer & to, const std::string & text) {to.i(TEXT).s(text);}
inline void pack(Packer & to, const char * text) {to.i(TEXT).s(text);}
template<class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
void pack(Packer & to, T number)
{
  if constexpr (std::is_floating_point_v<T>) {
    to.i(REAL).d(number);
  } else {
    to.i(INTEGER).i(static_cast<int64_t>(number));
  }
}
template<class ... A>
void pack_tuple(Packer & to, const A & ... items)
{
  to.i(TUPLE).i(sizeof...(items));
  (pack(to, items), ...);
}
template<class T>
void pack(Packer & to, const Size_<T> & size) {pack_tuple(to, size.width, size.height);}
template<class T>
void pack(Packer & to, const Point_<T> & at) {pack_tuple(to, at.x, at.y);}
template<class T>
void pack(Packer & to, const Rect_<T> & rect) {pack_tuple(to, rect.x, rect.y, rect.width, rect.height);}
inline void pack(Packer & to, const Scalar & s) {pack_tuple(to, s[0], s[1], s[2], s[3]);}
inline void pack(Packer & to, const TermCriteria & end) {pack_tuple(to, end.type, end.maxCount, end.epsilon);}
inline void pack(Packer & to, const RotatedRect & rect)
{
  to.i(TUPLE).i(3);
  pack(to, rect.center);
  pack(to, rect.size);
  pack(to, rect.angle);
}
inline void pack(Packer & to, const std::vector<Mat> & all)
{
  to.i(LIST).i(static_cast<int64_t>(all.size()));
  for (auto & one : all) {
    pack(to, one);
  }
}
template<class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
void pack(Packer & to, const std::vector<T> & all)
{
  to.i(LIST).i(static_cast<int64_t>(all.size()));
  for (T one : all) {
    pack(to, one);
  }
}

/// An argument by its name: those that Python has after its output arrays.
template<class T>
struct Keyword
{
  const char * name;
  const T & value;
};
template<class T>
Keyword<T> kw(const char * name, const T & value) {return {name, value};}
template<class T>
void pack(Packer & to, const Keyword<T> & given)
{
  to.i(KEYWORD).s(given.name);
  pack(to, given.value);
}

inline Value unpack(Unpacker & from)
{
  Value value;
  value.kind = from.i();
  switch (value.kind) {
    case INTEGER: value.integer = from.i(); break;
    case REAL: value.real = from.d(); break;
    case TEXT: value.text = from.s(); break;
    case MAT: {
        int rows = static_cast<int>(from.i()), cols = static_cast<int>(from.i());
        int depth = static_cast<int>(from.i()), channels = static_cast<int>(from.i());
        value.mat.create(rows, cols, CV_MAKETYPE(depth, channels));
        std::string bytes = from.s();
        std::memcpy(value.mat.data, bytes.data(), std::min(bytes.size(), value.mat.total() * value.mat.elemSize()));
        break;
      }
    case LIST:
    case TUPLE:
      for (int64_t count = from.i(); count > 0; --count) {
        value.items.push_back(unpack(from));
      }
      break;
    default: break;
  }
  return value;
}

inline Value asked(const char * what, const Packer & with)
{
  try {
    Unpacker answer = coursekit::request(what, with);
    return unpack(answer);
  } catch (const coursekit::Refused & refusal) {
    Exception error;
    error.msg = error.err = refusal.what();
    throw error;
  }
}
/// Call a function of cv2; Exception with its words where it refuses.
template<class ... A>
Value call(const char * name, const A & ... arguments)
{
  Packer with = Packer{}.s(name).i(sizeof...(arguments));
  (pack(with, arguments), ...);
  return asked("cv_call", with);
}

/// An object of cv2's, which lives as long as this.
class Object
{
public:
  template<class ... A>
  explicit Object(const char * kind, const A & ... arguments)
  {
    Packer with = Packer{}.s(kind).i(sizeof...(arguments));
    (pack(with, arguments), ...);
    id_ = asked("cv_make", with).integer;
  }
  Object(const Object &) = delete;
  Object & operator=(const Object &) = delete;
  ~Object() {coursekit::note("drop", Packer{}.i(id_));}
  template<class ... A>
  Value call(const char * name, const A & ... arguments) const
  {
    Packer with = Packer{}.i(id_).s(name).i(sizeof...(arguments));
    (pack(with, arguments), ...);
    return asked("cv_method", with);
  }

private:
  int64_t id_ = 0;
};
}  // namespace cv::remote
