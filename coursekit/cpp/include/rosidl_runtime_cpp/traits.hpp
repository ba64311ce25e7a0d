#pragma once
#include "rosidl_runtime_cpp/message.hpp"
