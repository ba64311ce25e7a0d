#pragma once
#include "image_transport/publisher.hpp"
