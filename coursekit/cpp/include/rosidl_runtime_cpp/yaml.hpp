// Messages as YAML: in lines, or in one line.
#pragma once
#include <cstring>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>

#include "coursekit/cdr.hpp"

namespace coursekit::yaml
{
/// Whether a member is only there because a structure of C needs one.
inline bool is_filler(const char * name) {return std::strcmp(name, "structure_needs_at_least_one_member") == 0;}

/// Whether a message's member is one of bytes.
template<class M, class = void>
struct octets
{
  static bool has(const char *) {return false;}
};
template<class M>
struct octets<M, std::void_t<decltype(M::coursekit_octets)>>
{
  static bool has(const char * name)
  {
    for (const char * octet : M::coursekit_octets) {
      if (std::strcmp(octet, name) == 0) {
        return true;
      }
    }
    return false;
  }
};

/// A single value as YAML has it; fractions always have a point, bytes two digits.
template<class T>
void write_value(const T & value, std::ostream & out, [[maybe_unused]] bool is_octet = false)
{
  if constexpr (std::is_same_v<T, bool>) {
    out << (value ? "true" : "false");
  } else if constexpr (std::is_floating_point_v<T>) {
    auto flags = out.flags();
    out << std::showpoint << value;
    out.flags(flags);
  } else if constexpr (std::is_integral_v<T>) {
    if (is_octet) {
      auto flags = out.flags();
      out << "0x" << std::hex << std::setw(2) << std::setfill('0') << +value;
      out.flags(flags);
    } else {
      out << +value;
    }
  } else {
    out << '"';
    for (auto letter : value) {
      if (letter == '"' || letter == '\\') {
        out << '\\';
      }
      if constexpr (sizeof letter == 1) {
        out << letter;
      } else if (letter < 0x80) {
        out << static_cast<char>(letter);
      } else {
        auto flags = out.flags();
        int width = letter < 0x100 ? 2 : 4;
        out << (width == 2 ? "\\x" : "\\u") << std::hex << std::setw(width) << std::setfill('0') << static_cast<unsigned>(letter);
        out.flags(flags);
      }
    }
    out << '"';
  }
}

template<class T>
struct is_text : std::false_type {};
template<class C>
struct is_text<std::basic_string<C>> : std::true_type {};
template<class T>
constexpr bool is_list = !std::is_arithmetic_v<T> && !is_text<T>::value && !is_message<T>::value;

template<class M, class = std::enable_if_t<is_message<M>::value>>
void to_flow_style_yaml(const M & message, std::ostream & out);

template<class T>
void write_flow(const T & value, std::ostream & out, [[maybe_unused]] bool is_octet)
{
  if constexpr (is_message<T>::value) {
    to_flow_style_yaml(value, out);
  } else if constexpr (is_list<T>) {
    const char * before = "[";
    for (const auto & item : value) {
      out << before;
      write_flow<typename T::value_type>(item, out, is_octet);
      before = ", ";
    }
    out << (value.size() ? "]" : "[]");
  } else {
    write_value(value, out, is_octet);
  }
}
template<class M, class>
void to_flow_style_yaml(const M & message, std::ostream & out)
{
  const char * before = "{";
  auto visit = [&](const char * name, const auto & field) {
      if (is_filler(name)) {
        return;
      }
      out << before << name << ": ";
      write_flow(field, out, octets<M>::has(name));
      before = ", ";
    };
  M::each_field(visit, message);
  out << (*before == '{' ? "null" : "}");
}

template<class M, class = std::enable_if_t<is_message<M>::value>>
void to_block_style_yaml(const M & message, std::ostream & out, size_t indentation = 0)
{
  const std::string margin(indentation, ' ');
  bool any = false;
  auto visit = [&](const char * name, const auto & field) {
      using T = std::decay_t<decltype(field)>;
      if (is_filler(name)) {
        return;
      }
      any = true;
      out << margin << name << ":";
      if constexpr (is_message<T>::value) {
        out << "\n";
        to_block_style_yaml(field, out, indentation + 2);
      } else if constexpr (is_list<T>) {
        out << (field.size() ? "\n" : " []\n");
        for (const auto & item : field) {
          out << margin << "-";
          if constexpr (is_message<typename T::value_type>::value) {
            out << "\n";
            to_block_style_yaml(item, out, indentation + 2);
          } else {
            out << " ";
            write_value<typename T::value_type>(item, out, octets<M>::has(name));
            out << "\n";
          }
        }
      } else {
        out << " ";
        write_value(field, out, octets<M>::has(name));
        out << "\n";
      }
    };
  M::each_field(visit, message);
  if (!any) {
    out << "null\n";
  }
}

template<class M, class = std::enable_if_t<is_message<M>::value>>
std::string to_yaml(const M & message, bool use_flow_style = false)
{
  std::ostringstream out;
  if (use_flow_style) {
    to_flow_style_yaml(message, out);
  } else {
    to_block_style_yaml(message, out);
  }
  return out.str();
}
}  // namespace coursekit::yaml

namespace rosidl_generator_traits
{
using coursekit::yaml::to_yaml;
}  // namespace rosidl_generator_traits
