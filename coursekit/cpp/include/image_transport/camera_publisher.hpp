#pragma once
#include "image_transport/camera.hpp"
