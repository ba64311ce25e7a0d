// Interfaces: names for numbers that belong to a piece of hardware.
#pragma once
#include <string>
#include <utility>

#include "hardware_interface/macros.hpp"
#include "hardware_interface/visibility_control.h"

namespace hardware_interface
{
class ReadOnlyHandle
{
public:
  ReadOnlyHandle(const std::string & prefix_name, const std::string & interface_name, double * value_ptr = nullptr)
  : prefix_name_(prefix_name), interface_name_(interface_name), value_ptr_(value_ptr) {}
  explicit ReadOnlyHandle(const std::string & interface_name)
  : ReadOnlyHandle("", interface_name) {}
  explicit ReadOnlyHandle(const char * interface_name)
  : ReadOnlyHandle("", interface_name) {}
  ReadOnlyHandle(const ReadOnlyHandle &) = default;
  ReadOnlyHandle(ReadOnlyHandle &&) = default;
  ReadOnlyHandle & operator=(const ReadOnlyHandle &) = default;
  ReadOnlyHandle & operator=(ReadOnlyHandle &&) = default;
  virtual ~ReadOnlyHandle() = default;

  /// Whether it has a number.
  operator bool() const {return value_ptr_ != nullptr;}
  const std::string get_name() const {return prefix_name_ + "/" + interface_name_;}
  [[deprecated("Use get_name() instead")]] const std::string get_full_name() const {return get_name();}
  const std::string & get_interface_name() const {return interface_name_;}
  const std::string & get_prefix_name() const {return prefix_name_;}
  double get_value() const
  {
    THROW_ON_NULLPTR(value_ptr_);
    return *value_ptr_;
  }

protected:
  std::string prefix_name_, interface_name_;
  double * value_ptr_;
};

class ReadWriteHandle : public ReadOnlyHandle
{
public:
  using ReadOnlyHandle::ReadOnlyHandle;
  void set_value(double value)
  {
    THROW_ON_NULLPTR(value_ptr_);
    *value_ptr_ = value;
  }
};

class StateInterface : public ReadOnlyHandle
{
public:
  using ReadOnlyHandle::ReadOnlyHandle;
};

/// Not copied: only one may write.
class CommandInterface : public ReadWriteHandle
{
public:
  using ReadWriteHandle::ReadWriteHandle;
  CommandInterface(const CommandInterface &) = delete;
  CommandInterface(CommandInterface &&) = default;
};
}  // namespace hardware_interface
