// Going through the items of a sequence and the pairs of a map: the end of node.h.
#pragma once
#include <iterator>

namespace YAML
{
/// What an iterator points to: an item of a sequence, or `first` and `second` of a map.
struct Node::Entry : Node, std::pair<Node, Node>
{
  explicit Entry(const Node & item)
  : Node(item), std::pair<Node, Node>(missing(""), missing("")) {}
  Entry(const Node & key, const Node & value)
  : Node(missing("")), std::pair<Node, Node>(key, value) {}
};

class Node::Iterator
{
public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = Entry;
  using difference_type = std::ptrdiff_t;
  using pointer = const Entry *;
  using reference = Entry;
  struct Arrow
  {
    Entry entry;
    Entry * operator->() {return &entry;}
  };
  Iterator() = default;
  Iterator(const Node & node, size_t at)
  : content_(node.place_->content), at_(at) {skip();}
  Entry operator*() const
  {
    return content_->type == NodeType::Map ?
           Entry(content_->pairs.at(at_).first, content_->pairs[at_].second) : Entry(content_->items.at(at_));
  }
  Arrow operator->() const {return {**this};}
  Iterator & operator++()
  {
    ++at_;
    skip();
    return *this;
  }
  Iterator operator++(int)
  {
    Iterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Iterator & other) const {return at_ == other.at_;}
  bool operator!=(const Iterator & other) const {return at_ != other.at_;}

private:
  void skip()
  {
    while (content_->type == NodeType::Map && at_ < content_->pairs.size() && !content_->pairs[at_].second.IsDefined()) {
      ++at_;
    }
  }
  std::shared_ptr<detail::Content> content_;
  size_t at_ = 0;
};
using iterator = Node::Iterator;
using const_iterator = Node::Iterator;

inline size_t Node::size() const
{
  checked();
  size_t count = content().type == NodeType::Sequence ? content().items.size() : 0;
  for (auto & pair : content().pairs) {
    count += pair.second.IsDefined();
  }
  return count;
}
inline Node::Iterator Node::begin() const {return valid_ ? Iterator(*this, 0) : end();}
inline Node::Iterator Node::end() const
{
  bool map = content().type == NodeType::Map;
  return Iterator(*this, map ? content().pairs.size() : content().items.size());
}
}  // namespace YAML
