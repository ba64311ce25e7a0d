// Texts that are read: by the session's reader of YAML.
#pragma once
#include <fstream>
#include <iterator>

#include "coursekit/link.hpp"
#include "yaml-cpp/node/convert.h"

namespace YAML
{
namespace detail
{
inline Node unpack(coursekit::Unpacker & from)
{
  Node node(static_cast<NodeType::value>(from.i()));
  auto & content = node.content();
  content.mark.line = static_cast<int>(from.i());
  content.mark.column = static_cast<int>(from.i());
  content.tag = from.s();
  content.style = from.i() ? EmitterStyle::Flow : EmitterStyle::Block;
  if (content.type == NodeType::Scalar) {
    content.quoted = from.i();
    content.scalar = from.s();
  } else if (content.type == NodeType::Sequence) {
    for (int64_t count = from.i(); count > 0; --count) {
      content.items.push_back(unpack(from));
    }
  } else if (content.type == NodeType::Map) {
    for (int64_t count = from.i(); count > 0; --count) {
      Node key = unpack(from), value = unpack(from);
      content.pairs.emplace_back(key, value);
    }
  }
  return node;
}
}  // namespace detail

/// Every document of a text.
inline std::vector<Node> LoadAll(const std::string & text)
{
  coursekit::Unpacker from = coursekit::request("yaml_nodes", coursekit::Packer{}.s(text));
  int64_t count = from.i();
  if (count < 0) {
    Mark at;
    at.line = static_cast<int>(from.i());
    at.column = static_cast<int>(from.i());
    throw ParserException(at, from.s());
  }
  std::vector<Node> documents;
  for (; count > 0; --count) {
    documents.push_back(detail::unpack(from));
  }
  return documents;
}
inline Node Load(const std::string & text)
{
  auto documents = LoadAll(text);
  return documents.empty() ? Node() : documents.front();
}
inline Node Load(std::istream & in) {return Load(std::string(std::istreambuf_iterator<char>(in), {}));}
inline std::vector<Node> LoadAll(std::istream & in) {return LoadAll(std::string(std::istreambuf_iterator<char>(in), {}));}
inline Node LoadFile(const std::string & name)
{
  std::ifstream in(name);
  if (!in) {
    throw BadFile(name);
  }
  return Load(in);
}
inline std::vector<Node> LoadAllFromFile(const std::string & name)
{
  std::ifstream in(name);
  if (!in) {
    throw BadFile(name);
  }
  return LoadAll(in);
}
}  // namespace YAML
