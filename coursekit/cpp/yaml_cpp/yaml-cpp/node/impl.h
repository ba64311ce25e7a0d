// Looking things up in a node, adding to it and taking away.
#pragma once
#include "yaml-cpp/node/node.h"

namespace YAML
{
inline void Node::push_back(const Node & item)
{
  checked();
  if (content().type == NodeType::Scalar || content().type == NodeType::Map) {
    throw BadPushback();
  }
  content().type = NodeType::Sequence;
  content().items.push_back(item);
  define(*place_);
}
template<class K>
Node Node::at(const K & key, bool make) const
{
  checked();
  auto & own = content();
  if (own.type == NodeType::Scalar) {
    throw BadSubscript(own.mark, text_of(key));
  }
  if constexpr (std::is_integral_v<K> && !std::is_same_v<K, bool>) {
    auto index = static_cast<size_t>(key);
    if (own.type == NodeType::Sequence && index < own.items.size()) {
      return own.items[index];
    }
    if (make && own.type == NodeType::Sequence && index == own.items.size()) {
      own.items.emplace_back(NodeType::Undefined);
      return own.items.back();
    }
  }
  std::string name = text_of(key);
  if (own.type != NodeType::Sequence) {
    for (auto & pair : own.pairs) {
      if (pair.first.content().scalar == name && (make || pair.second.IsDefined())) {
        return pair.second;
      }
    }
  }
  if (!make) {
    return missing(name);
  }
  Node value(NodeType::Undefined);
  value.place_->parent = place_;
  if (own.type != NodeType::Sequence) {
    own.pairs.emplace_back(Node(name), value);
  }
  return value;
}
template<class K>
bool Node::remove(const K & key)
{
  auto & own = content();
  if constexpr (std::is_integral_v<K>) {
    if (own.type == NodeType::Sequence && static_cast<size_t>(key) < own.items.size()) {
      return remove_first(own.items, [&](const Node & item) {return &item == &own.items[static_cast<size_t>(key)];});
    }
  }
  std::string name = text_of(key);
  return remove_first(own.pairs, [&](auto & pair) {return pair.first.content().scalar == name;});
}
inline Node Clone(const Node & node)
{
  Node copy(node.Type());
  Node::replace(copy.content(), node.content());
  for (auto & item : copy.content().items) {
    item.reset(Clone(item));
  }
  for (auto & pair : copy.content().pairs) {
    pair.first.reset(Clone(pair.first));
    pair.second.reset(Clone(pair.second));
  }
  return copy;
}
}  // namespace YAML
