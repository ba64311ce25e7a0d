#pragma once
#include "opencv2/video.hpp"
