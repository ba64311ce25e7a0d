// Texts that are written bit by bit.
#pragma once
#include <iostream>

#include "yaml-cpp/node/emit.h"

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
  /// It follows what was written last, on the same line; the first of all has a line of its own.
  Emitter & operator<<(const _Comment & comment)
  {
    std::string & text = last_.IsDefined() ? last_.content().comment : head_;
    text += text.empty() ? comment.content : "  # " + comment.content;
    return *this;
  }
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
    const std::string head = head_.empty() ? "" : detail::commented(head_, 0);
    return whole.IsDefined() ? (head.empty() ? head : head + "\n") + Dump(whole) : head;
  }
  void begin(NodeType::value type)
  {
    Node node(type);
    node.SetStyle(style_);
    style_ = EmitterStyle::Default;
    last_.reset(node);
    levels_.push_back({node, false, Node()});
  }
  void end(NodeType::value type, const char * error)
  {
    if (levels_.empty() || levels_.back().node.Type() != type) {
      error_ = error;
      return;
    }
    Node done = levels_.back().node, last = last_;
    levels_.pop_back();
    add(done);
    if (detail::is_block(done)) {
      last_.reset(last);  // its last line ends with its last value
    }
  }
  Emitter & add(const Node & node)
  {
    node.content().quoted = node.content().quoted || quoted_;
    quoted_ = false;
    last_.reset(node);
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
  Node root_{NodeType::Undefined}, last_{NodeType::Undefined};
  std::string head_;
  EmitterStyle::value style_ = EmitterStyle::Default;
  bool quoted_ = false;
  _Precision digits_{0, 0};
  std::string error_;
  mutable std::string made_;
};
}  // namespace YAML
