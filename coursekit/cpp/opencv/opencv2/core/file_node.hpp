// What was read from a file of settings: numbers, texts and matrices, in sequences and under names.
#pragma once
#include "opencv2/core/array.hpp"

namespace cv
{
class FileNodeIterator;

/// A part of what was read; an empty one for what there is not.
class FileNode
{
public:
  enum {NONE = 0, INT = 1, REAL = 2, FLOAT = REAL, STR = 3, STRING = STR, SEQ = 4, MAP = 5, TYPE_MASK = 7, FLOW = 8};

  FileNode() = default;
  /// As the session sends it: its type, its name, its value or its parts, and its matrix.
  explicit FileNode(std::shared_ptr<const remote::Value> read)
  : read_(std::move(read)) {}

  int type() const {return read_ ? static_cast<int>((*read_)[0].integer) : NONE;}
  String name() const {return read_ ? (*read_)[1].text : "";}
  bool empty() const {return !read_;}
  bool isNone() const {return type() == NONE;}
  bool isInt() const {return type() == INT;}
  bool isReal() const {return type() == REAL;}
  bool isString() const {return type() == STR;}
  bool isSeq() const {return type() == SEQ;}
  bool isMap() const {return type() == MAP;}
  bool isNamed() const {return !name().empty();}
  size_t size() const {return isSeq() || isMap() ? content().items.size() : isNone() ? 0 : 1;}
  std::vector<String> keys() const
  {
    std::vector<String> names;
    for (size_t i = 0; isMap() && i < size(); ++i) {
      names.push_back(at(i).name());
    }
    return names;
  }
  FileNode operator[](const String & name) const
  {
    for (size_t i = 0; isMap() && i < size(); ++i) {
      if (FileNode part = at(i); part.name() == name) {
        return part;
      }
    }
    return FileNode();
  }
  FileNode operator[](const char * name) const {return (*this)[String(name)];}
  FileNode operator[](int i) const {return isSeq() && i >= 0 && static_cast<size_t>(i) < size() ? at(i) : FileNode();}
  /// The part at a place.
  FileNode at(size_t i) const {return FileNode(std::shared_ptr<const remote::Value>(read_, &content()[i]));}
  FileNodeIterator begin() const;
  FileNodeIterator end() const;

  double real() const {return isInt() || isReal() ? content().number() : std::numeric_limits<double>::max();}
  String string() const {return isString() ? content().text : "";}
  Mat mat() const {return isMap() ? (*read_)[3].mat : Mat();}
  operator int() const {return isInt() ? static_cast<int>(content().integer) : isReal() ? cvRound(real()) : isNone() ? 0 : 0x7fffffff;}
  operator double() const {return isNone() ? 0 : real();}
  operator float() const {return static_cast<float>(static_cast<double>(*this));}
  operator String() const {return string();}

private:
  const remote::Value & content() const {return (*read_)[2];}
  std::shared_ptr<const remote::Value> read_;
};

/// Goes from part to part.
class FileNodeIterator
{
public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = FileNode;
  using difference_type = std::ptrdiff_t;
  using pointer = const FileNode *;
  using reference = FileNode;
  FileNodeIterator() = default;
  FileNodeIterator(FileNode of, size_t place)
  : of_(std::move(of)), place_(place) {}
  FileNode operator*() const {return of_.at(place_);}
  FileNodeIterator & operator++() {++place_; return *this;}
  FileNodeIterator operator++(int) {FileNodeIterator old = *this; ++place_; return old;}
  FileNodeIterator & operator+=(int n) {place_ += static_cast<size_t>(n); return *this;}
  size_t remaining() const {return of_.size() - place_;}
  bool operator==(const FileNodeIterator & other) const {return place_ == other.place_;}
  bool operator!=(const FileNodeIterator & other) const {return place_ != other.place_;}

private:
  FileNode of_;
  size_t place_ = 0;
};
inline FileNodeIterator FileNode::begin() const {return {*this, 0};}
inline FileNodeIterator FileNode::end() const {return {*this, isSeq() || isMap() ? size() : 0};}

inline void read(const FileNode & from, int & value, int other) {value = from.empty() ? other : static_cast<int>(from);}
inline void read(const FileNode & from, bool & value, bool other) {value = from.empty() ? other : static_cast<int>(from) != 0;}
inline void read(const FileNode & from, float & value, float other) {value = from.empty() ? other : static_cast<float>(from);}
inline void read(const FileNode & from, double & value, double other) {value = from.empty() ? other : static_cast<double>(from);}
inline void read(const FileNode & from, String & value, const String & other) {value = from.empty() ? other : from.string();}
inline void read(const FileNode & from, Mat & value, const Mat & other = Mat())
{
  if (!from.empty() && from.mat().empty() && from["dt"].empty()) {
    throw Exception(-215, "Assertion failed: the node is no matrix", "read", __FILE__, __LINE__);
  }
  value = from.empty() ? other : from.mat();
}
template<class T>
void operator>>(const FileNode & from, T & value) {read(from, value, T());}
namespace detail
{
/// Read the numbers of a sequence; none is written where the node is none.
template<class ... T>
void read_row(const FileNode & from, T & ... numbers)
{
  int place = 0;
  (read(from[place++], numbers, T()), ...);
}
}  // namespace detail
template<class T>
void read(const FileNode & from, std::vector<T> & all, const std::vector<T> & other = {})
{
  all = from.empty() ? other : std::vector<T>();
  for (FileNode one : from) {
    T value;
    one >> value;
    all.push_back(value);
  }
}
template<class T>
void read(const FileNode & from, Point_<T> & p, const Point_<T> &) {detail::read_row(from, p.x, p.y);}
template<class T>
void read(const FileNode & from, Point3_<T> & p, const Point3_<T> &) {detail::read_row(from, p.x, p.y, p.z);}
template<class T>
void read(const FileNode & from, Size_<T> & s, const Size_<T> &) {detail::read_row(from, s.width, s.height);}
template<class T>
void read(const FileNode & from, Rect_<T> & r, const Rect_<T> &) {detail::read_row(from, r.x, r.y, r.width, r.height);}
inline void read(const FileNode & from, Scalar & s, const Scalar &) {detail::read_row(from, s[0], s[1], s[2], s[3]);}
template<class T>
FileNodeIterator & operator>>(FileNodeIterator & from, T & value)
{
  *from >> value;
  return ++from;
}
}  // namespace cv
