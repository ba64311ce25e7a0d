#pragma once
#include "opencv2/features2d.hpp"
