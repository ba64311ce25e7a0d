// A filter that gives its parameter `key`, whatever comes.
#pragma once
#include "filters/filter_base.hpp"

namespace filters
{
template<typename T>
class ParamTest : public FilterBase<T>
{
public:
  bool configure() override {return true;}
  bool update(const T &, T & data_out) override
  {
    T value{};
    this->getParam("key", value);
    data_out = value;
    return true;
  }
};
}  // namespace filters
