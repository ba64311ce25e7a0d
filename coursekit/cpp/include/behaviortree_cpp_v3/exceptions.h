// What trees throw.
#pragma once
#include <exception>
#include <string>

#include "behaviortree_cpp_v3/utils/strcat.hpp"

namespace BT
{
class BehaviorTreeException : public std::exception
{
public:
  BehaviorTreeException(nonstd::string_view message)
  : message_(message) {}
  template<class ... Texts>
  BehaviorTreeException(const Texts & ... texts)
  : message_(StrCat(texts ...)) {}
  const char * what() const noexcept override {return message_.c_str();}

private:
  std::string message_;
};

/// A mistake in the program or the tree.
class LogicError : public BehaviorTreeException
{
public:
  using BehaviorTreeException::BehaviorTreeException;
};

/// Something that only shows when it runs.
class RuntimeError : public BehaviorTreeException
{
public:
  using BehaviorTreeException::BehaviorTreeException;
};
}  // namespace BT
