// What generated messages stand on: the members that each of them has, and what programs ask of a message type.
#pragma once
#include <memory>
#include <utility>

#include "rosidl_runtime_cpp/message_initialization.hpp"
#include "rosidl_runtime_cpp/traits.hpp"
#include "rosidl_runtime_cpp/yaml.hpp"

#define COURSEKIT_MESSAGE(Name, full_name) \
  static constexpr const char * coursekit_type = full_name; \
  using Type = Name; \
  using SharedPtr = std::shared_ptr<Name>; \
  using ConstSharedPtr = std::shared_ptr<const Name>; \
  using UniquePtr = std::unique_ptr<Name>; \
  using ConstUniquePtr = std::unique_ptr<const Name>; \
  template<class D = std::default_delete<Name>> \
  using UniquePtrWithDeleter = std::unique_ptr<Name, D>; \
  using WeakPtr = std::weak_ptr<Name>; \
  using ConstWeakPtr = std::weak_ptr<const Name>; \
  using RawPtr = Name *; \
  using ConstRawPtr = const Name *; \
  using Name ## _ = Name;

/// A step of a builder's chain: it takes one field, and leads to the next step or to the message.
#define COURSEKIT_STEP(Name, field, Next) \
  class Init_ ## Name ## _ ## field \
  { \
public: \
    explicit Init_ ## Name ## _ ## field(Name && message) \
    : message_(std::move(message)) {} \
    template<class = void> \
    Next field(Name::_ ## field ## _type value) \
    { \
      message_.field = std::move(value); \
      return Next(std::move(message_)); \
    } \
private: \
    Name message_; \
  };
