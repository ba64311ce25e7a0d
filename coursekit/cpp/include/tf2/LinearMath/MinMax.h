// The smaller and the larger of two numbers, and one kept between two others.
#pragma once

template<class T>
const T & tf2Min(const T & a, const T & b) {return a < b ? a : b;}
template<class T>
const T & tf2Max(const T & a, const T & b) {return a > b ? a : b;}
template<class T>
const T & GEN_clamped(const T & a, const T & lower, const T & upper) {return a < lower ? lower : upper < a ? upper : a;}
template<class T>
void tf2SetMin(T & a, const T & b) {a = tf2Min(a, b);}
template<class T>
void tf2SetMax(T & a, const T & b) {a = tf2Max(a, b);}
template<class T>
void GEN_clamp(T & a, const T & lower, const T & upper) {a = GEN_clamped(a, lower, upper);}
