#pragma once
#include "opencv2/videoio.hpp"
