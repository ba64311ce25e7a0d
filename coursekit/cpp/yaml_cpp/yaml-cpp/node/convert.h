// Between nodes and the types of a program; a program adds its own by specializing convert.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <map>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "yaml-cpp/node/node.h"

namespace YAML
{
template<>
struct convert<Node>
{
  static Node encode(const Node & node) {return node;}
  static bool decode(const Node & node, Node & to)
  {
    to.reset(node);
    return true;
  }
};
template<>
struct convert<std::string>
{
  static Node encode(const std::string & text)
  {
    Node node(NodeType::Scalar);
    node.content().scalar = text;
    return node;
  }
  static bool decode(const Node & node, std::string & to)
  {
    to = node.Scalar();
    return node.IsScalar();
  }
};
template<size_t n>
struct convert<char[n]>
{
  static Node encode(const char * text) {return Node(std::string(text));}
};
template<>
struct convert<const char *>
{
  static Node encode(const char * text) {return Node(std::string(text));}
};
template<>
struct convert<bool>
{
  static Node encode(bool value) {return Node(std::string(value ? "true" : "false"));}
  static bool decode(const Node & node, bool & to)
  {
    static const std::pair<const char *, const char *> names[] = {{"y", "n"}, {"yes", "no"}, {"true", "false"}, {"on", "off"}};
    std::string text = node.Scalar(), lower;
    for (char c : text) {
      lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    bool all_upper = true, rest_lower = true;
    for (size_t i = 0; i < text.size(); ++i) {
      all_upper = all_upper && text[i] != lower[i];
      rest_lower = rest_lower && (i == 0 || text[i] == lower[i]);
    }
    for (auto & [yes, no] : names) {
      if (node.IsScalar() && (all_upper || rest_lower) && (lower == yes || lower == no)) {
        to = lower == yes;
        return true;
      }
    }
    return false;
  }
};
template<class T>
struct convert<T, std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>>>
{
  static Node encode(T value)
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<T>::max_digits10);
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(value)) {
        return Node(std::string(std::isnan(value) ? ".nan" : value > 0 ? ".inf" : "-.inf"));
      }
      text << value;
    } else if constexpr (std::is_same_v<T, char>) {
      text << value;
    } else {
      text << +value;
    }
    return Node(text.str());
  }
  static bool decode(const Node & node, T & to)
  {
    if (!node.IsScalar()) {
      return false;
    }
    const std::string & text = node.Scalar();
    std::istringstream from(text);
    from.unsetf(std::ios::dec);  // 0x1F, too
    if (std::is_unsigned_v<T> && from.peek() == '-') {
      return false;
    }
    if constexpr (sizeof(T) == 1 && !std::is_same_v<T, char>) {
      int number = 0;
      bool read = (from >> number) && (from >> std::ws).eof();
      to = static_cast<T>(number);
      return read && number >= std::numeric_limits<T>::min() && number <= std::numeric_limits<T>::max();
    } else if ((from >> std::noskipws >> to) && (from >> std::ws).eof()) {
      return true;
    }
    if constexpr (std::is_floating_point_v<T>) {
      return special(text, to);
    }
    return false;
  }

private:
  static bool special(const std::string & text, T & to)
  {
    std::string name = text.substr(text.size() > 1 && (text[0] == '-' || text[0] == '+') ? 1 : 0);
    if (name == ".inf" || name == ".Inf" || name == ".INF") {
      to = text[0] == '-' ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity();
      return true;
    }
    to = std::numeric_limits<T>::quiet_NaN();
    return name == text && (name == ".nan" || name == ".NaN" || name == ".NAN");
  }
};

namespace detail
{
template<class L>
struct Several
{
  static Node encode(const L & items)
  {
    Node node(NodeType::Sequence);
    for (const auto & item : items) {
      node.push_back(Node(static_cast<const typename L::value_type &>(item)));
    }
    return node;
  }
  static bool decode(const Node & node, L & to)
  {
    to.clear();
    for (const auto & item : node) {
      to.push_back(static_cast<const Node &>(item).template as<typename L::value_type>());
    }
    return node.IsSequence();
  }
};
template<class M>
struct Keyed
{
  static Node encode(const M & values)
  {
    Node node(NodeType::Map);
    for (auto & pair : values) {
      node.force_insert(pair.first, pair.second);
    }
    return node;
  }
  static bool decode(const Node & node, M & to)
  {
    to.clear();
    if (!node.IsMap()) {
      return false;
    }
    for (const auto & pair : node) {
      to[pair.first.template as<typename M::key_type>()] = pair.second.template as<typename M::mapped_type>();
    }
    return true;
  }
};
}  // namespace detail
template<class T, class A>
struct convert<std::vector<T, A>> : detail::Several<std::vector<T, A>> {};
template<class T, class A>
struct convert<std::list<T, A>> : detail::Several<std::list<T, A>> {};
template<class K, class V, class C, class A>
struct convert<std::map<K, V, C, A>> : detail::Keyed<std::map<K, V, C, A>> {};
template<class K, class V, class H, class E, class A>
struct convert<std::unordered_map<K, V, H, E, A>> : detail::Keyed<std::unordered_map<K, V, H, E, A>> {};
template<class T, size_t n>
struct convert<std::array<T, n>>
{
  static Node encode(const std::array<T, n> & items) {return Node(std::vector<T>(items.begin(), items.end()));}
  static bool decode(const Node & node, std::array<T, n> & to)
  {
    if (!node.IsSequence() || node.size() != n) {
      return false;
    }
    for (size_t i = 0; i < n; ++i) {
      to[i] = node[i].template as<T>();
    }
    return true;
  }
};
template<class T, class U>
struct convert<std::pair<T, U>>
{
  static Node encode(const std::pair<T, U> & both)
  {
    Node node(NodeType::Sequence);
    node.push_back(both.first);
    node.push_back(both.second);
    return node;
  }
  static bool decode(const Node & node, std::pair<T, U> & to)
  {
    if (!node.IsSequence() || node.size() != 2) {
      return false;
    }
    to = {node[0].template as<T>(), node[1].template as<U>()};
    return true;
  }
};
}  // namespace YAML
