// A node as text.
#pragma once
#include <iostream>

#include "yaml-cpp/node/convert.h"

namespace YAML
{
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
/// A comment's lines, all but the first behind so many spaces.
inline std::string commented(const std::string & comment, size_t indent)
{
  std::string made = "# ";
  for (char c : comment) {
    made += c;
    if (c == '\n') {
      made += std::string(indent, ' ') + "# ";
    }
  }
  return made;
}
/// The comment that follows on a line that has begun.
inline void write_comment(std::ostream & out, const Node & node, size_t indent)
{
  if (!node.content().comment.empty()) {
    out << "  " << commented(node.content().comment, indent);
  }
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
        write_comment(out, item, indent);
      } else if (item.IsMap() && item.content().comment.empty()) {
        out << " ";
        write_block(out, item, indent + 2);
      } else {
        write_comment(out, item, indent);
        out << "\n" << std::string(indent + 2, ' ');
        write_block(out, item, indent + 2);
      }
    } else {
      write_flow(out, entry.first);
      out << ":";
      if (is_block(entry.second)) {
        write_comment(out, entry.second, indent);
        out << "\n" << std::string(indent + 2, ' ');
        write_block(out, entry.second, indent + 2);
      } else {
        out << " ";
        write_flow(out, entry.second);
        write_comment(out, entry.second, indent);
      }
    }
  }
}
}  // namespace detail

inline std::ostream & operator<<(std::ostream & out, const Node & node)
{
  if (detail::is_block(node)) {
    if (!node.content().comment.empty()) {
      out << detail::commented(node.content().comment, 0) << "\n";
    }
    detail::write_block(out, node, 0);
  } else {
    detail::write_flow(out, node);
    if (node.IsDefined()) {
      detail::write_comment(out, node, 0);
    }
  }
  return out;
}
inline std::string Dump(const Node & node)
{
  std::ostringstream out;
  out << node;
  return out.str();
}
}  // namespace YAML
