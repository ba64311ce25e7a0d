#pragma once
#include "rmw/types.h"
