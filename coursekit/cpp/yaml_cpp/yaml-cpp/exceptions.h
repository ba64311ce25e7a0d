// What yaml-cpp throws, and in which words.
#pragma once
#include <stdexcept>
#include <string>

namespace YAML
{
/// A place in a text, from 0; -1 for none.
struct Mark
{
  int pos = -1, line = -1, column = -1;
  static Mark null_mark() {return {};}
  bool is_null() const {return line < 0;}
};

class Exception : public std::runtime_error
{
public:
  Exception(const Mark & mark_, const std::string & msg_)
  : std::runtime_error(told(mark_, msg_)), mark(mark_), msg(msg_) {}
  Mark mark;
  std::string msg;

private:
  static std::string told(const Mark & at, const std::string & text)
  {
    return at.is_null() ? text :
           "yaml-cpp: error at line " + std::to_string(at.line + 1) + ", column " + std::to_string(at.column + 1) + ": " + text;
  }
};
class ParserException : public Exception
{
public:
  using Exception::Exception;
};
class RepresentationException : public Exception
{
public:
  using Exception::Exception;
};
class InvalidNode : public RepresentationException
{
public:
  explicit InvalidNode(const std::string & key)
  : RepresentationException(
      {}, key.empty() ? "invalid node; this may result from using a map iterator as a sequence iterator, or vice-versa" :
      "invalid node; first invalid key: \"" + key + "\"") {}
};
class BadConversion : public RepresentationException
{
public:
  explicit BadConversion(const Mark & at)
  : RepresentationException(at, "bad conversion") {}
};
template<class T>
class TypedBadConversion : public BadConversion
{
public:
  using BadConversion::BadConversion;
};
class BadDereference : public RepresentationException
{
public:
  BadDereference()
  : RepresentationException({}, "bad dereference") {}
};
class BadSubscript : public RepresentationException
{
public:
  BadSubscript(const Mark & at, const std::string & key)
  : RepresentationException(at, "operator[] call on a scalar (key: \"" + key + "\")") {}
};
class BadPushback : public RepresentationException
{
public:
  BadPushback()
  : RepresentationException({}, "appending to a non-sequence") {}
};
class EmitterException : public Exception
{
public:
  explicit EmitterException(const std::string & text)
  : Exception({}, text) {}
};
class BadFile : public Exception
{
public:
  explicit BadFile(const std::string & name)
  : Exception({}, "bad file: " + name) {}
};
}  // namespace YAML
