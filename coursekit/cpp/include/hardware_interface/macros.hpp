// A check of pointers that throws.
#pragma once
#include <stdexcept>
#include <string>

#ifdef _MSC_VER
#define __PRETTY_FUNCTION__ __FUNCTION__
#endif

#define THROW_ON_NULLPTR(pointer) \
  if (!(pointer)) { \
    throw std::runtime_error(std::string(__PRETTY_FUNCTION__) + " failed. " #pointer " is null."); \
  }
