// Texts that are written: from a node, or bit by bit.
#pragma once
#include <iostream>

#include "yaml-cpp/node/convert.h"

namespace YAML
{
enum EMITTER_MANIP
{
  Auto, TagByKind, Newline, EmitNonAscii, EscapeNonAscii, EscapeAsJson, SingleQuoted, DoubleQuoted, Literal, YesNoBool,
  TrueFalseBool, OnOffBool, UpperCase, LowerCase, CamelCase, LongBool, ShortBool, Dec, Hex, Oct, LowerNull, UpperNull,
  CamelNull, TildeNull, BeginDoc, EndDoc, BeginSeq, EndSeq, Flow, Block, BeginMap, EndMap, Key, Value, LongKey
};
struct _Null {};
inline _Null Null;
struct _Comment {std::string content;};
inline _Comment Comment(const std::string & text) {return {text};}
struct _Precision {int floats, doubles;};
inline _Precision Precision(int digits) {return {digits, digits};}
inline _Precision FloatPrecision(int digits) {return {digits, -1};}
inline _Precision DoublePrecision(int digits) {return {-1, digits};}

namespace detail
{
/// A scalar as it must be written to be read as the same text.
inline std::string written(const Content & scalar)
{
  const std::string & text = scalar.scalar;
  static const std::string first = "-?:,[]{}#&*!|>'\"%@` ";
  bool plain = !scalar.quoted && !text.empty() && (first.find(text[0]) == std::string::npos ||
    (text.size() > 1 && (text[0] == '-' || text[0] == '?' || text[0] == ':') && text[1] != ' ')) && text.back() != ' ' &&
    text.back() != ':' && text.find(": ") == std::string::npos && text.find(" #") == std::string::npos && text != "~" &&
    text != "null" && text != "-" && text.find_first_of("\n\t\r[]{},\\\"") == std::string::npos;
  if (plain) {
    return text;
  }
  std::string made = "\"";
  for (char c : text) {
    switch (c) {
      case '"': made += "\\\""; break;
      case '\\': made += "\\\\"; break;
      case '\n': made += "\\n"; break;
      case '\t': made += "\\t"; break;
      case '\r': made += "\\r"; break;
      default: made += c;
    }
  }
  return made + "\"";
}
inline void write_flow(std::ostream & out, const Node & node)
{
  const char * between = "";
  switch (node.Type()) {
    case NodeType::Sequence:
      out << "[";
      for (const auto & item : node) {
        out << between;
        write_flow(out, item);
        between = ", ";
      }
      out << "]";
      break;
    case NodeType::Map:
      out << "{";
      for (const auto & pair : node) {
        out << between;
        write_flow(out, pair.first);
        out << ": ";
        write_flow(out, pair.second);
        between = ", ";
      }
      out << "}";
      break;
    case NodeType::Scalar: out << written(node.content()); break;
    default: out << "~";
  }
}
inline bool is_block(const Node & node)
{
  return (node.IsSequence() || node.IsMap()) && node.size() > 0 && node.Style() != EmitterStyle::Flow;
}
/// A node whose first line has begun already; the others begin with so many spaces.
inline void write_block(std::ostream & out, const Node & node, size_t indent)
{
  std::string line_break;
  for (const auto & entry : node) {
    out << line_break;
    line_break = "\n" + std::string(indent, ' ');
    if (node.IsSequence()) {
      const Node & item = entry;
      out << "-";
      if (!is_block(item)) {
        out << " ";
        write_flow(out, item);
      } else if (item.IsMap()) {
        out << " ";
        write_block(out, item, indent + 2);
      } else {
        out << "\n" << std::string(indent + 2, ' ');
        write_block(out, item, indent + 2);
      }
    } else {
      write_flow(out, entry.first);
      out << ":";
      if (is_block(entry.second)) {
        out << "\n" << std::string(indent + 2, ' ');
        write_block(out, entry.second, indent + 2);
      } else {
        out << " ";
        write_flow(out, entry.second);
      }
    }
  }
}
}  // namespace detail

inline std::ostream & operator<<(std::ostream & out, const Node & node)
{
  if (detail::is_block(node)) {
    detail::write_block(out, node, 0);
  } else {
    detail::write_flow(out, node);
  }
  return out;
}
inline std::string Dump(const Node & node)
{
  std::ostringstream out;
  out << node;
  return out.str();
}

/// Collects what is written to it; the text is there when all that began has ended.
class Emitter
{
public:
  Emitter() = default;
  explicit Emitter(std::ostream & out)
  : out_(&out) {}
  ~Emitter()
  {
    if (out_) {
      *out_ << text();
    }
  }
  Emitter & operator<<(EMITTER_MANIP word)
  {
    switch (word) {
      case BeginSeq: begin(NodeType::Sequence); break;
      case BeginMap: begin(NodeType::Map); break;
      case EndSeq: end(NodeType::Sequence, "unexpected end sequence token"); break;
      case EndMap: end(NodeType::Map, "unexpected end map token"); break;
      case Flow: style_ = EmitterStyle::Flow; break;
      case Block: style_ = EmitterStyle::Block; break;
      case SingleQuoted:
      case DoubleQuoted: quoted_ = true; break;
      default: break;
    }
    return *this;
  }
  Emitter & operator<<(const _Null &) {return add(Node());}
  Emitter & operator<<(const _Comment &) {return *this;}  // what is read back has no comments
  Emitter & operator<<(const _Precision & digits)
  {
    digits_ = digits;
    return *this;
  }
  template<class T>
  Emitter & operator<<(const T & value)
  {
    if constexpr (std::is_floating_point_v<T>) {
      int digits = std::is_same_v<T, float> ? digits_.floats : digits_.doubles;
      if (digits > 0) {
        std::ostringstream text;
        text.precision(digits);
        text << value;
        return add(Node(text.str()));
      }
    }
    return add(Node(value));
  }
  bool good() const {return error_.empty();}
  const std::string GetLastError() const {return error_;}
  const char * c_str() const
  {
    made_ = text();
    return made_.c_str();
  }
  size_t size() const {return text().size();}
  void SetIndent(size_t) {}
  void SetDoublePrecision(size_t digits) {digits_.doubles = static_cast<int>(digits);}
  void SetFloatPrecision(size_t digits) {digits_.floats = static_cast<int>(digits);}

private:
  struct Level
  {
    Node node;
    bool has_key;
    Node key;
  };
  std::string text() const
  {
    const Node & whole = levels_.empty() ? root_ : levels_.front().node;
    return whole.IsDefined() ? Dump(whole) : "";
  }
  void begin(NodeType::value type)
  {
    Node node(type);
    node.SetStyle(style_);
    style_ = EmitterStyle::Default;
    levels_.push_back({node, false, Node()});
  }
  void end(NodeType::value type, const char * error)
  {
    if (levels_.empty() || levels_.back().node.Type() != type) {
      error_ = error;
      return;
    }
    Node done = levels_.back().node;
    levels_.pop_back();
    add(done);
  }
  Emitter & add(const Node & node)
  {
    node.content().quoted = node.content().quoted || quoted_;
    quoted_ = false;
    if (style_ != EmitterStyle::Default) {
      node.content().style = style_;
      style_ = EmitterStyle::Default;
    }
    if (levels_.empty()) {
      root_.reset(node);
    } else if (levels_.back().node.IsSequence()) {
      levels_.back().node.push_back(node);
    } else if (!levels_.back().has_key) {
      levels_.back().key.reset(node);
      levels_.back().has_key = true;
    } else {
      levels_.back().node.force_insert(levels_.back().key, node);
      levels_.back().has_key = false;
    }
    return *this;
  }

  std::ostream * out_ = nullptr;
  std::vector<Level> levels_;
  Node root_{NodeType::Undefined};
  EmitterStyle::value style_ = EmitterStyle::Default;
  bool quoted_ = false;
  _Precision digits_{0, 0};
  std::string error_;
  mutable std::string made_;
};
}  // namespace YAML
