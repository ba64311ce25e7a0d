// A DiagnosticStatus that can be filled with few words.
#pragma once
#include <cstdarg>
#include <cstdio>
#include <sstream>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_status.hpp"

namespace diagnostic_updater
{
class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus
{
public:
  void summary(unsigned char level, const std::string & text)
  {
    this->level = level;
    message = text;
  }
  void summary(const diagnostic_msgs::msg::DiagnosticStatus & other) {summary(other.level, other.message);}
  void summaryf(unsigned char level, const char * format, ...)
  {
    std::va_list words;
    va_start(words, format);
    summary(level, printed(format, words));
    va_end(words);
  }
  void clearSummary() {summary(OK, "");}
  /// The worse of two levels; the words of both where they are equally well or ill.
  /// Faults are joined; of two good states the first stays.
  void mergeSummary(unsigned char level, const std::string & text)
  {
    if (level > OK && this->level > OK) {
      message += (message.empty() || text.empty() ? "" : "; ") + text;
    } else if (level > this->level) {
      message = text;
    }
    this->level = std::max(this->level, level);
  }
  void mergeSummary(const diagnostic_msgs::msg::DiagnosticStatus & other) {mergeSummary(other.level, other.message);}
  void mergeSummaryf(unsigned char level, const char * format, ...)
  {
    std::va_list words;
    va_start(words, format);
    mergeSummary(level, printed(format, words));
    va_end(words);
  }
  template<class T>
  void add(const std::string & key, const T & value)
  {
    std::ostringstream text;
    text << value;
    values.push_back(diagnostic_msgs::msg::KeyValue().set__key(key).set__value(text.str()));
  }
  void add(const std::string & key, const bool & value) {add(key, value ? "True" : "False");}
  void addf(const std::string & key, const char * format, ...)
  {
    std::va_list words;
    va_start(words, format);
    add(key, printed(format, words));
    va_end(words);
  }
  void clear() {values.clear();}

private:
  static std::string printed(const char * format, std::va_list words)
  {
    char text[1000];
    std::vsnprintf(text, sizeof text, format, words);
    return text;
  }
};
}  // namespace diagnostic_updater
