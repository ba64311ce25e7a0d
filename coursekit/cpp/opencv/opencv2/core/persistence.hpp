// Files of settings in YAML, XML or JSON: Python's cv2 writes and parses them.
#pragma once
#include <filesystem>

#include "opencv2/core/file_node.hpp"

namespace cv
{
class FileStorage
{
public:
  enum Mode
  {
    READ = 0, WRITE = 1, APPEND = 2, MEMORY = 4, FORMAT_MASK = 7 << 3, FORMAT_AUTO = 0, FORMAT_XML = 1 << 3,
    FORMAT_YAML = 2 << 3, FORMAT_JSON = 3 << 3, BASE64 = 64, WRITE_BASE64 = BASE64 | WRITE
  };
  enum State {UNDEFINED = 0, VALUE_EXPECTED = 1, NAME_EXPECTED = 2, INSIDE_MAP = 4};

  FileStorage() = default;
  FileStorage(const String & filename, int flags, const String & encoding = String()) {open(filename, flags, encoding);}
  /// A file's name, or with MEMORY its content. False where it cannot be opened.
  bool open(const String & filename, int flags, const String & = String())
  {
    release();
    const bool in_memory = flags & MEMORY;
    const String where = in_memory ? filename : std::filesystem::absolute(filename).string();
    if (flags & (WRITE | APPEND)) {
      file_ = std::make_shared<remote::Object>("FileStorage", where, flags);
      opened_ = file_->call("isOpened").integer;
      state = NAME_EXPECTED | INSIDE_MAP;
      levels_.assign(1, FileNode::MAP);
    } else if (in_memory || std::filesystem::is_regular_file(where)) {
      root_ = FileNode(std::make_shared<const remote::Value>(remote::call("file_nodes", where, flags)));
      opened_ = true;
    }
    return opened_;
  }
  bool isOpened() const {return opened_;}
  void release() {releaseAndGetString();}
  /// Close it; with MEMORY, what was written.
  String releaseAndGetString()
  {
    String text;
    if (file_ && file_.use_count() == 1) {
      text = file_->call("releaseAndGetString").text;
    }
    file_.reset();
    *this = FileStorage(Closed{});
    return text;
  }
  ~FileStorage() {close_last();}
  FileStorage(const FileStorage &) = default;
  FileStorage & operator=(const FileStorage &) = default;

  FileNode root(int = 0) const {return root_;}
  FileNode getFirstTopLevelNode() const {return root_.size() ? *root_.begin() : FileNode();}
  FileNode operator[](const String & name) const {return root_[name];}
  FileNode operator[](const char * name) const {return root_[name];}

  template<class T>
  void write(const String & name, const T & value) {file_->call("write", name, value);}
  void writeComment(const String & comment, bool append = false) {file_->call("writeComment", comment, append);}
  void startWriteStruct(const String & name, int flags, const String & type_name = String())
  {
    file_->call("startWriteStruct", name, flags, type_name);
    levels_.push_back(flags & FileNode::TYPE_MASK);
    expect_next();
  }
  void endWriteStruct()
  {
    if (levels_.size() < 2) {
      throw Exception(-5, "Extra closing bracket", "endWriteStruct", __FILE__, __LINE__);
    }
    file_->call("endWriteStruct");
    levels_.pop_back();
    expect_next();
  }
  /// What was written is a name, a bracket, or a value; whatever follows is the next.
  void take(const String & text);
  void expect_next() {state = levels_.back() == FileNode::MAP ? NAME_EXPECTED | INSIDE_MAP : VALUE_EXPECTED;}

  String elname;
  int state = UNDEFINED;

private:
  struct Closed {};
  explicit FileStorage(Closed) {}
  void close_last()
  {
    if (file_ && file_.use_count() == 1) {
      try {
        file_->call("release");
      } catch (const Exception &) {
      }
    }
  }
  std::shared_ptr<remote::Object> file_;
  FileNode root_;
  bool opened_ = false;
  std::vector<int> levels_;
};

inline void write(FileStorage & to, const String & name, int value) {to.write(name, value);}
inline void write(FileStorage & to, const String & name, float value) {to.write(name, static_cast<double>(value));}
inline void write(FileStorage & to, const String & name, double value) {to.write(name, value);}
inline void write(FileStorage & to, const String & name, const String & value) {to.write(name, value);}
inline void write(FileStorage & to, const String & name, const Mat & value) {to.write(name, value);}
template<class T>
void write(FileStorage & to, const String & name, const std::vector<T> & all)
{
  to.startWriteStruct(name, FileNode::SEQ | (std::is_arithmetic_v<T> ? FileNode::FLOW : 0));
  for (const T & one : all) {
    write(to, String(), one);
  }
  to.endWriteStruct();
}
namespace detail
{
template<class ... T>
void write_row(FileStorage & to, const String & name, T ... numbers)
{
  to.startWriteStruct(name, FileNode::SEQ | FileNode::FLOW);
  (write(to, String(), numbers), ...);
  to.endWriteStruct();
}
}  // namespace detail
template<class T>
void write(FileStorage & to, const String & name, const Point_<T> & p) {detail::write_row(to, name, p.x, p.y);}
template<class T>
void write(FileStorage & to, const String & name, const Point3_<T> & p) {detail::write_row(to, name, p.x, p.y, p.z);}
template<class T>
void write(FileStorage & to, const String & name, const Size_<T> & s) {detail::write_row(to, name, s.width, s.height);}
template<class T>
void write(FileStorage & to, const String & name, const Rect_<T> & r)
{
  detail::write_row(to, name, r.x, r.y, r.width, r.height);
}
inline void write(FileStorage & to, const String & name, const Scalar & s) {detail::write_row(to, name, s[0], s[1], s[2], s[3]);}

inline void FileStorage::take(const String & text)
{
  const bool opens = !text.empty() && (text[0] == '{' || text[0] == '['), closes = text == "}" || text == "]";
  if (closes) {
    endWriteStruct();
  } else if (state & NAME_EXPECTED) {
    elname = text;
    state = VALUE_EXPECTED | (state & INSIDE_MAP);
  } else if (opens) {
    const int flow = text.size() > 1 && text[1] == ':' ? FileNode::FLOW : 0;
    startWriteStruct(levels_.back() == FileNode::MAP ? elname : String(), (text[0] == '{' ? FileNode::MAP : FileNode::SEQ) | flow);
  } else {
    write(levels_.back() == FileNode::MAP ? elname : String(), text);
    expect_next();
  }
}
inline FileStorage & operator<<(FileStorage & to, const String & text)
{
  if (to.isOpened()) {
    to.take(text);
  }
  return to;
}
inline FileStorage & operator<<(FileStorage & to, const char * text) {return to << String(text);}
inline FileStorage & operator<<(FileStorage & to, char * text) {return to << String(text);}
template<class T>
FileStorage & operator<<(FileStorage & to, const T & value)
{
  if (!to.isOpened()) {
    return to;
  }
  if (to.state & FileStorage::NAME_EXPECTED) {
    throw Exception(-2, "No element name has been given", "operator <<", __FILE__, __LINE__);
  }
  write(to, to.state & FileStorage::INSIDE_MAP ? to.elname : String(), value);
  to.expect_next();
  return to;
}
}  // namespace cv
