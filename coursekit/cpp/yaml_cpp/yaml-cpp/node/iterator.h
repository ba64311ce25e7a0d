#pragma once
#include "yaml-cpp/node/node.h"
