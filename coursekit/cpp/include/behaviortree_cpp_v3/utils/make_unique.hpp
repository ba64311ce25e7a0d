// std::make_unique, for which programs include this.
#pragma once
#include <memory>
