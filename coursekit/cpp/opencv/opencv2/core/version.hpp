#pragma once
#include "opencv2/core/exception.hpp"
