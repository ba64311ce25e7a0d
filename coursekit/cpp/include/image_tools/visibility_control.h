// Programs are linked whole, so nothing needs to be exported; packages that follow the demos of images use these names.
#pragma once
#define IMAGE_TOOLS_PUBLIC
#define IMAGE_TOOLS_LOCAL
