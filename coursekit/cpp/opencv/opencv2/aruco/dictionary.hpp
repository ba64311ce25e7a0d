#pragma once
#include "opencv2/aruco.hpp"
