// What goes over the link: packed integers, doubles, texts and messages.
#pragma once
#include <functional>

#include "coursekit/cdr.hpp"

namespace coursekit
{
/// Packs values one after the other: numbers take eight bytes, texts their length and themselves.
struct Packer
{
  std::string bytes;
  Packer & i(int64_t value) {return raw(&value, 8);}
  Packer & d(double value) {return raw(&value, 8);}
  Packer & s(const std::string & value)
  {
    i(static_cast<int64_t>(value.size()));
    bytes += value;
    return *this;
  }
  template<class M>
  Packer & m(const M & message) {return s(to_cdr(message));}
  Packer & raw(const void * data, size_t size)
  {
    bytes.append(static_cast<const char *>(data), size);
    return *this;
  }
};

/// Unpacks them again; throws std::runtime_error where there is less than asked for.
struct Unpacker
{
  std::string bytes;
  size_t at = 0;
  int64_t i() {int64_t value; take(&value, 8); return value;}
  double d() {double value; take(&value, 8); return value;}
  std::string s()
  {
    size_t size = static_cast<size_t>(i());
    need(size);
    at += size;
    return bytes.substr(at - size, size);
  }
  /// The next texts, after how many they are.
  std::vector<std::string> texts()
  {
    std::vector<std::string> all;
    for (int64_t count = i(); count > 0; --count) {
      all.push_back(s());
    }
    return all;
  }
  template<class M>
  M m() {M message; from_cdr(s(), message); return message;}
  /// All that has not been read yet.
  std::string rest() const {return bytes.substr(at);}

private:
  void take(void * to, size_t size)
  {
    need(size);
    std::memcpy(to, bytes.data() + at, size);
    at += size;
  }
  void need(size_t size) const
  {
    if (bytes.size() - at < size) {
      throw std::runtime_error("coursekit: a frame is too short");
    }
  }
};

/// Called by the session: reads its arguments, packs its result.
using Handler = std::function<void (Unpacker &, Packer &)>;
}  // namespace coursekit
