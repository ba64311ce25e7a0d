// Marks of what a library shows to others: here everything is visible.
#pragma once

#define HARDWARE_INTERFACE_EXPORT
#define HARDWARE_INTERFACE_IMPORT
#define HARDWARE_INTERFACE_PUBLIC
#define HARDWARE_INTERFACE_PUBLIC_TYPE
#define HARDWARE_INTERFACE_LOCAL
