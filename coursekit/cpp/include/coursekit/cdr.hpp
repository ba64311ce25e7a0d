// Messages as bytes: CDR as DDS has it (XCDR version 1, little endian), by each message's own each_field().
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "rosidl_runtime_cpp/bounded_vector.hpp"

namespace coursekit
{
/// Whether T is a generated message.
template<class T, class = void>
struct is_message : std::false_type {};
template<class T>
struct is_message<T, std::void_t<typename T::ConstRawPtr, decltype(T::coursekit_type)>> : std::true_type {};

/// Appends a message to a string; alignment counts from the end of CDR's own four bytes.
class CdrWriter
{
public:
  explicit CdrWriter(std::string & bytes)
  : bytes_(bytes)
  {
    bytes_.append("\0\1\0\0", 4);
    start_ = bytes_.size();
  }
  template<class T>
  void operator()(const char *, const T & value) {put(value);}

  template<class T>
  void put(const T & value)
  {
    if constexpr (is_message<T>::value) {
      T::each_field(*this, value);
    } else {
      put_scalar(value);
    }
  }
  void put(const std::string & value)
  {
    put_scalar<uint32_t>(value.size() + 1);
    bytes_.append(value.c_str(), value.size() + 1);
  }
  void put(const std::u16string & value)
  {
    put_scalar<uint32_t>(value.size());
    for (char16_t unit : value) {
      put_scalar<uint32_t>(unit);
    }
  }
  template<class T, size_t N>
  void put(const std::array<T, N> & value) {put_items(value.data(), N);}
  template<class T>
  void put(const std::vector<T> & value) {put_sequence(value);}
  template<class T, size_t N>
  void put(const rosidl_runtime_cpp::BoundedVector<T, N> & value) {put_sequence(value);}

private:
  template<class Sequence>
  void put_sequence(const Sequence & value)
  {
    put_scalar<uint32_t>(value.size());
    if constexpr (std::is_same_v<typename Sequence::value_type, bool>) {
      for (bool item : value) {
        put_scalar(item);
      }
    } else {
      put_items(value.data(), value.size());
    }
  }
  template<class T>
  void put_scalar(T value)
  {
    align(sizeof(T));
    bytes_.append(reinterpret_cast<const char *>(&value), sizeof(T));
  }
  template<class T>
  void put_items(const T * items, size_t count)
  {
    if constexpr (std::is_arithmetic_v<T>) {
      if (count) {
        align(sizeof(T));
        bytes_.append(reinterpret_cast<const char *>(items), count * sizeof(T));
      }
    } else {
      for (size_t i = 0; i < count; ++i) {
        put(items[i]);
      }
    }
  }
  void align(size_t size) {bytes_.append((size - (bytes_.size() - start_) % size) % size, '\0');}

  std::string & bytes_;
  size_t start_;
};

/// Reads what CdrWriter writes; throws std::runtime_error where the bytes end too early.
class CdrReader
{
public:
  CdrReader(const char * data, size_t size)
  : at_(data + 4), start_(data + 4), end_(data + size)
  {
    if (size < 4) {
      fail();
    }
  }
  template<class T>
  void operator()(const char *, T & value) {get(value);}

  template<class T>
  void get(T & value)
  {
    if constexpr (is_message<T>::value) {
      T::each_field(*this, value);
    } else {
      get_scalar(value);
    }
  }
  void get(std::string & value)
  {
    size_t size = get_count(1);
    value.assign(at_, size ? size - 1 : 0);
    at_ += size;
  }
  void get(std::u16string & value)
  {
    value.resize(get_count(4));
    for (auto & unit : value) {
      uint32_t code;
      get_scalar(code);
      unit = static_cast<char16_t>(code);
    }
  }
  template<class T, size_t N>
  void get(std::array<T, N> & value) {get_items(value.data(), N);}
  template<class T>
  void get(std::vector<T> & value) {get_sequence(value);}
  template<class T, size_t N>
  void get(rosidl_runtime_cpp::BoundedVector<T, N> & value) {get_sequence(value);}

private:
  template<class Sequence>
  void get_sequence(Sequence & value)
  {
    using Item = typename Sequence::value_type;
    value.resize(get_count(std::is_arithmetic_v<Item>? sizeof(Item) : 1));
    if constexpr (std::is_same_v<Item, bool>) {
      for (size_t i = 0; i < value.size(); ++i) {
        bool item;
        get_scalar(item);
        value[i] = item;
      }
    } else {
      get_items(value.data(), value.size());
    }
  }
  template<class T>
  void get_scalar(T & value)
  {
    align(sizeof(T));
    need(sizeof(T));
    std::memcpy(&value, at_, sizeof(T));
    at_ += sizeof(T);
  }
  /// How many items follow, of at least so many bytes each: a false count must not take all memory.
  size_t get_count(size_t item_size)
  {
    uint32_t count;
    get_scalar(count);
    if (count > static_cast<size_t>(end_ - at_) / item_size) {
      fail();
    }
    return count;
  }
  template<class T>
  void get_items(T * items, size_t count)
  {
    if constexpr (std::is_arithmetic_v<T>) {
      if (count) {
        align(sizeof(T));
        need(count * sizeof(T));
        std::memcpy(items, at_, count * sizeof(T));
        at_ += count * sizeof(T);
      }
    } else {
      for (size_t i = 0; i < count; ++i) {
        get(items[i]);
      }
    }
  }
  void align(size_t size)
  {
    size_t gap = (size - (at_ - start_) % size) % size;
    need(gap);
    at_ += gap;
  }
  void need(size_t size) const
  {
    if (static_cast<size_t>(end_ - at_) < size) {
      fail();
    }
  }
  [[noreturn]] static void fail() {throw std::runtime_error("these bytes are no message of that type");}

  const char * at_;
  const char * start_;
  const char * end_;
};

/// A message's bytes.
template<class M>
std::string to_cdr(const M & message)
{
  std::string bytes;
  CdrWriter writer(bytes);
  writer.put(message);
  return bytes;
}
/// Fill a message from its bytes.
template<class M>
void from_cdr(const std::string & bytes, M & message)
{
  CdrReader reader(bytes.data(), bytes.size());
  reader.get(message);
}
}  // namespace coursekit
