// A value of a YAML text: a scalar, a sequence or a map. Copies of a Node are the same value.
#pragma once
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "yaml-cpp/exceptions.h"

namespace YAML
{
struct NodeType
{
  enum value {Undefined, Null, Scalar, Sequence, Map};
};
struct EmitterStyle
{
  enum value {Default, Block, Flow};
};
class Node;
template<class T, class Enable = void>
struct convert;

namespace detail
{
struct Content
{
  NodeType::value type = NodeType::Undefined;
  EmitterStyle::value style = EmitterStyle::Default;
  bool quoted = false;
  std::string scalar, tag;
  Mark mark;
  std::vector<Node> items;
  std::vector<std::pair<Node, Node>> pairs;
};
/// What a Node points to. One that a map was asked for in vain belongs to it as soon as it gets a value.
struct Place
{
  std::shared_ptr<Content> content = std::make_shared<Content>();
  std::weak_ptr<Place> parent;
};
}  // namespace detail

class Node
{
public:
  struct Entry;
  class Iterator;
  using iterator = Iterator;
  using const_iterator = Iterator;

  Node()
  : Node(NodeType::Null) {}
  explicit Node(NodeType::value type)
  : place_(std::make_shared<detail::Place>()) {content().type = type;}
  Node(const Node &) = default;
  template<class T>
  explicit Node(const T & value)
  : Node(convert<T>::encode(value)) {}
  explicit Node(const char * text)
  : Node(std::string(text)) {}
  /// In place of what a const map does not have.
  static Node missing(const std::string & key)
  {
    Node node(NodeType::Undefined);
    node.valid_ = false;
    node.key_ = key;
    return node;
  }

  NodeType::value Type() const
  {
    checked();
    return content().type;
  }
  bool IsDefined() const {return valid_ && content().type != NodeType::Undefined;}
  bool IsNull() const {return Type() == NodeType::Null;}
  bool IsScalar() const {return Type() == NodeType::Scalar;}
  bool IsSequence() const {return Type() == NodeType::Sequence;}
  bool IsMap() const {return Type() == NodeType::Map;}
  explicit operator bool() const {return IsDefined();}
  bool operator!() const {return !IsDefined();}
  bool is(const Node & other) const {return place_->content == other.place_->content;}
  bool operator==(const Node & other) const {return is(other);}

  const std::string & Scalar() const
  {
    checked();
    return content().scalar;
  }
  const std::string & Tag() const {return content().tag;}
  void SetTag(const std::string & tag) {content().tag = tag;}
  YAML::Mark Mark() const
  {
    checked();
    return content().mark;
  }
  EmitterStyle::value Style() const {return content().style;}
  void SetStyle(EmitterStyle::value style) {content().style = style;}

  template<class T>
  T as() const
  {
    checked();
    if constexpr (std::is_same_v<T, std::string>) {
      if (IsNull()) {
        return "null";
      }
    }
    T value{};
    if (!IsDefined() || !convert<T>::decode(*this, value)) {
      throw TypedBadConversion<T>(content().mark);
    }
    return value;
  }
  template<class T, class S>
  T as(const S & otherwise) const
  {
    T value{};
    return IsDefined() && convert<T>::decode(*this, value) ? value : static_cast<T>(otherwise);
  }

  template<class T>
  Node & operator=(const T & value)
  {
    checked();
    replace(*place_->content, convert<T>::encode(value).content());
    define(*place_);
    return *this;
  }
  Node & operator=(const char * text) {return *this = std::string(text);}
  Node & operator=(const Node & other)
  {
    checked();
    other.checked();
    place_->content = other.place_->content;
    define(*place_);
    place_ = other.place_;
    return *this;
  }
  void reset(const Node & other = Node())
  {
    place_ = other.place_;
    valid_ = other.valid_;
  }

  size_t size() const;
  Iterator begin() const;
  Iterator end() const;
  template<class T>
  void push_back(const T & value) {push_back(Node(value));}
  void push_back(const Node & item);
  template<class K>
  Node operator[](const K & key) {return at(key, true);}
  template<class K>
  const Node operator[](const K & key) const {return at(key, false);}
  template<class K>
  bool remove(const K & key);
  template<class K, class V>
  void force_insert(const K & key, const V & value)
  {
    content().type = NodeType::Map;
    content().pairs.emplace_back(Node(key), Node(value));
    define(*place_);
  }

  detail::Content & content() const {return *place_->content;}
  /// Copy a content as a whole: to assign a Node is to change the value that it stands for.
  static void replace(detail::Content & to, detail::Content with) {std::swap(to, with);}

private:
  template<class T, class F>
  static bool remove_first(std::vector<T> & all, F && is_it)
  {
    std::vector<T> kept;
    bool removed = false;
    for (auto & one : all) {
      if (removed || !is_it(one)) {
        kept.push_back(one);
      } else {
        removed = true;
      }
    }
    all.swap(kept);
    return removed;
  }
  template<class K>
  Node at(const K & key, bool make) const;
  template<class K>
  static std::string text_of(const K & key)
  {
    if constexpr (std::is_convertible_v<K, std::string>) {
      return key;
    } else {
      return convert<K>::encode(key).Scalar();
    }
  }
  void checked() const
  {
    if (!valid_) {
      throw InvalidNode(key_);
    }
  }
  /// A place has a value now; what it was looked up in is a map from now on, if it was nothing.
  static void define(detail::Place & place)
  {
    if (place.content->type == NodeType::Undefined) {
      place.content->type = NodeType::Null;
    }
    if (auto parent = place.parent.lock()) {
      place.parent.reset();
      if (parent->content->type < NodeType::Scalar) {
        parent->content->type = NodeType::Map;
      }
      define(*parent);
    }
  }

  std::shared_ptr<detail::Place> place_;
  bool valid_ = true;
  std::string key_;
};

/// What an iterator points to: an item of a sequence, or `first` and `second` of a map.
struct Node::Entry : Node, std::pair<Node, Node>
{
  explicit Entry(const Node & item)
  : Node(item), std::pair<Node, Node>(missing(""), missing("")) {}
  Entry(const Node & key, const Node & value)
  : Node(missing("")), std::pair<Node, Node>(key, value) {}
  Entry(const Entry &) = default;
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
