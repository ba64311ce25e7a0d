// yaml-cpp where the system has none: nodes, texts that are read, texts that are written.
#pragma once
#include "yaml-cpp/emitter.h"
#include "yaml-cpp/exceptions.h"
#include "yaml-cpp/node/convert.h"
#include "yaml-cpp/node/emit.h"
#include "yaml-cpp/node/node.h"
#include "yaml-cpp/node/parse.h"
