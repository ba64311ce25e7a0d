// Trace points, for LTTng on a robot. Nothing is traced here.
#pragma once
#define TRACEPOINT(...) ((void)0)
#define DECLARE_TRACEPOINT(...)
inline bool ros_trace_compile_status() {return false;}
