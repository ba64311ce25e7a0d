#pragma once
#include "image_transport/exception.hpp"
