// Cameras and films.
#pragma once
#include "opencv2/core.hpp"

#include "coursekit/opencv/camera.hpp"
