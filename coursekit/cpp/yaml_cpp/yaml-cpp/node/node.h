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
  std::string comment;  // an Emitter's, behind the value, or behind what opens the collection
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

}  // namespace YAML

#include "yaml-cpp/node/detail/iterator.h"
#include "yaml-cpp/node/impl.h"
#include "yaml-cpp/node/convert.h"  // last: it goes through nodes
