// Reads XML from its beginning to its end, a mark at a time.
#include "xml.hpp"

#include <cstdlib>

namespace coursekit::xml
{
namespace
{
constexpr std::pair<char, const char *> ENTITIES[] = {
  {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}};

std::string utf8(unsigned long code)  // NOLINT
{
  if (code < 0x80) {
    return {static_cast<char>(code)};
  }
  std::string bytes;
  for (; code >= (bytes.empty() ? 0x40u : 0x40u >> bytes.size()); code >>= 6) {
    bytes.insert(bytes.begin(), static_cast<char>(0x80 | (code & 0x3f)));
  }
  const auto lead = static_cast<unsigned char>(0xf00 >> (bytes.size() + 1));
  bytes.insert(bytes.begin(), static_cast<char>(lead | code));
  return bytes;
}

class Reader
{
public:
  explicit Reader(const std::string & text)
  : text_(text), at_(text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0) {}

  Element document()
  {
    skip_to_element();
    if (at_ == text_.size()) {
      fail("XML_ERROR_EMPTY_DOCUMENT", "there is no element");
    }
    Element top = element();
    skip_to_element();
    if (at_ != text_.size()) {
      fail("XML_ERROR_PARSING", "there is something behind the end of <" + top.name + ">");
    }
    return top;
  }

private:
  [[noreturn]] void fail(const std::string & kind, const std::string & why) const
  {
    throw Error(kind + ", line " + std::to_string(line_) + ": " + why);
  }
  bool starts(const char * mark) const {return text_.compare(at_, std::char_traits<char>::length(mark), mark) == 0;}
  bool at_space() const {return at_ < text_.size() && std::string(" \t\r\n").find(text_[at_]) != std::string::npos;}

  void advance(size_t count)
  {
    for (; count > 0 && at_ < text_.size(); --count) {
      line_ += text_[at_++] == '\n';
    }
  }
  void skip_spaces()
  {
    while (at_space()) {
      advance(1);
    }
  }
  void skip_past(const char * mark, const char * what)
  {
    const size_t found = text_.find(mark, at_);
    if (found == std::string::npos) {
      fail("XML_ERROR_PARSING", std::string(what) + " does not end");
    }
    advance(found - at_ + std::char_traits<char>::length(mark));
  }
  /// Pass over texts, comments and the like, until an element begins or ends.
  void skip_to_element()
  {
    for (;;) {
      const size_t next = std::min(text_.find('<', at_), text_.size());
      advance(next - at_);
      if (starts("<!--")) {
        skip_past("-->", "a comment");
      } else if (starts("<![CDATA[")) {
        skip_past("]]>", "a CDATA section");
      } else if (starts("<?")) {
        skip_past("?>", "a declaration");
      } else if (starts("<!")) {
        skip_past(">", "a declaration");
      } else {
        return;
      }
    }
  }
  std::string name()
  {
    const size_t begin = at_;
    while (at_ < text_.size() && !at_space() && std::string("=<>/\"'").find(text_[at_]) == std::string::npos) {
      ++at_;
    }
    if (at_ == begin) {
      fail("XML_ERROR_PARSING_ELEMENT", "a name is missing");
    }
    return text_.substr(begin, at_ - begin);
  }
  Element element()
  {
    Element read;
    read.line = line_;
    advance(1);
    read.name = name();
    while (!starts(">") && !starts("/>")) {
      attribute(read);
    }
    const bool empty = starts("/>");
    advance(empty ? 2 : 1);
    if (!empty) {
      children(read);
    }
    return read;
  }
  void attribute(Element & to)
  {
    const bool apart = at_space();
    skip_spaces();
    if (starts(">") || starts("/>")) {
      return;
    }
    if (at_ == text_.size() || !apart) {
      fail("XML_ERROR_PARSING_ELEMENT", "<" + to.name + "> has no end");
    }
    const std::string key = name();
    skip_spaces();
    const bool has_value = starts("=");
    advance(has_value);
    skip_spaces();
    if (!has_value || (!starts("\"") && !starts("'"))) {
      fail("XML_ERROR_PARSING_ATTRIBUTE", "the attribute '" + key + "' of <" + to.name + "> has no value in quotes");
    }
    if (to.attribute(key)) {
      fail("XML_ERROR_PARSING_ATTRIBUTE", "<" + to.name + "> has the attribute '" + key + "' twice");
    }
    to.attributes.emplace_back(key, value(to.name, key));
  }
  std::string value(const std::string & element, const std::string & key)
  {
    const char quote = text_[at_];
    const size_t end = text_.find(quote, at_ + 1);
    if (end == std::string::npos) {
      fail("XML_ERROR_PARSING_ATTRIBUTE", "the value of '" + key + "' of <" + element + "> has no end");
    }
    const std::string raw = text_.substr(at_ + 1, end - at_ - 1);
    advance(end + 1 - at_);
    return unescaped(raw);
  }
  static std::string unescaped(const std::string & raw)
  {
    std::string plain;
    for (size_t i = 0; i < raw.size(); ) {
      const size_t end = raw[i] == '&' ? raw.find(';', i) : std::string::npos;
      const std::string entity = end == std::string::npos ? "" : raw.substr(i, end + 1 - i);
      const std::string meant = character(entity);
      plain += meant.empty() ? std::string(1, raw[i]) : meant;
      i += meant.empty() ? 1 : entity.size();
    }
    return plain;
  }
  static std::string character(const std::string & entity)
  {
    for (auto & known : ENTITIES) {
      if (entity == known.second) {
        return {known.first};
      }
    }
    if (entity.compare(0, 2, "&#") != 0) {
      return "";
    }
    const bool hexadecimal = entity[2] == 'x';
    return utf8(std::strtoul(entity.c_str() + (hexadecimal ? 3 : 2), nullptr, hexadecimal ? 16 : 10));
  }
  void children(Element & to)
  {
    for (;;) {
      skip_to_element();
      if (at_ == text_.size()) {
        fail("XML_ERROR_MISMATCHED_ELEMENT", "<" + to.name + "> of line " + std::to_string(to.line) + " is not closed");
      }
      if (!starts("</")) {
        to.children.push_back(element());
        continue;
      }
      advance(2);
      const std::string closed = name();
      skip_spaces();
      if (closed != to.name || !starts(">")) {
        fail(
          "XML_ERROR_MISMATCHED_ELEMENT",
          "<" + to.name + "> of line " + std::to_string(to.line) + " is closed by </" + closed + ">");
      }
      advance(1);
      return;
    }
  }

  const std::string & text_;
  size_t at_;
  int line_ = 1;
};
}  // namespace

const std::string * Element::attribute(const std::string & key) const
{
  for (auto & one : attributes) {
    if (one.first == key) {
      return &one.second;
    }
  }
  return nullptr;
}
Element read(const std::string & text) {return Reader(text).document();}

std::string escaped(const std::string & text)
{
  std::string safe;
  for (char character : text) {
    const char * entity = nullptr;
    for (auto & known : ENTITIES) {
      entity = known.first == character ? known.second : entity;
    }
    safe += entity ? std::string(entity) : std::string(1, character);
  }
  return safe;
}
}  // namespace coursekit::xml
