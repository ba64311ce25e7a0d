/* The functions of <complex.h> that Wine's ucrtbase only names (up to version 10), which numpy and scipy import.
   Computed from real ones, in double precision; the float ones go through them. No header and no C library of the
   compiler's is used: zig would take minutes to make them. */

#define FROM_WINE __declspec(dllimport) double
FROM_WINE hypot(double, double);
FROM_WINE atan2(double, double);
FROM_WINE exp(double);
FROM_WINE log(double);
FROM_WINE log10(double);
FROM_WINE sin(double);
FROM_WINE cos(double);
FROM_WINE sinh(double);
FROM_WINE cosh(double);
#define sqrt __builtin_sqrt
#define fabs __builtin_fabs
#define copysign __builtin_copysign
#define isinf __builtin_isinf
#define INFINITY __builtin_inf()

int _fltused = 1; /* what a library with such numbers has to name, and the function that every one begins with */
int __stdcall DllMainCRTStartup(void *library, unsigned reason, void *reserved) { return 1; }

typedef double _Complex Z;
typedef float _Complex F;
#define RE(z) (__real__(z))
#define IM(z) (__imag__(z))

static Z rect(double re, double im) { Z z; RE(z) = re; IM(z) = im; return z; }

static double my_creal(Z z) { return RE(z); }
static double my_cimag(Z z) { return IM(z); }
static double my_cabs(Z z) { return hypot(RE(z), IM(z)); }
static double my_carg(Z z) { return atan2(IM(z), RE(z)); }

static Z my_conj(Z z) { return rect(RE(z), -IM(z)); }
static Z my_cproj(Z z) { return isinf(RE(z)) || isinf(IM(z)) ? rect(INFINITY, copysign(0, IM(z))) : z; }
static Z my_clog(Z z) { return rect(log(my_cabs(z)), my_carg(z)); }
static Z my_clog10(Z z) { return rect(log10(my_cabs(z)), my_carg(z) / log(10)); }

static Z my_cexp(Z z) {
  double size = exp(RE(z));
  return IM(z) == 0 ? rect(size, IM(z)) : rect(size * cos(IM(z)), size * sin(IM(z)));
}

static Z my_csqrt(Z z) {
  double size = my_cabs(z), half;
  if (size == 0) return rect(0, IM(z));
  half = sqrt((size + fabs(RE(z))) / 2);
  return RE(z) >= 0 ? rect(half, IM(z) / (2 * half)) : rect(fabs(IM(z)) / (2 * half), copysign(half, IM(z)));
}

static Z my_csinh(Z z) { return rect(sinh(RE(z)) * cos(IM(z)), cosh(RE(z)) * sin(IM(z))); }
static Z my_ccosh(Z z) { return rect(cosh(RE(z)) * cos(IM(z)), sinh(RE(z)) * sin(IM(z))); }

static Z my_ctanh(Z z) {
  double below = cosh(2 * RE(z)) + cos(2 * IM(z));
  return fabs(RE(z)) > 20 ? rect(copysign(1, RE(z)), 0) : rect(sinh(2 * RE(z)) / below, sin(2 * IM(z)) / below);
}

/* sin z = -i sinh(iz), and likewise the other two. */
static Z my_csin(Z z) { Z turned = my_csinh(rect(-IM(z), RE(z))); return rect(IM(turned), -RE(turned)); }
static Z my_ccos(Z z) { return my_ccosh(rect(-IM(z), RE(z))); }
static Z my_ctan(Z z) { Z turned = my_ctanh(rect(-IM(z), RE(z))); return rect(IM(turned), -RE(turned)); }

static Z my_cpow(Z z, Z w) {
  Z ln;
  if (my_cabs(z) == 0) return rect(my_cabs(w) == 0, 0);
  ln = my_clog(z);
  return my_cexp(rect(RE(w) * RE(ln) - IM(w) * IM(ln), RE(w) * IM(ln) + IM(w) * RE(ln)));
}

#define TO_REAL(name)                                   \
  double shim_##name(Z z) { return my_##name(z); }      \
  float shim_##name##f(F z) { return (float)my_##name(z); }
#define TO_COMPLEX(name)                                \
  Z shim_##name(Z z) { return my_##name(z); }           \
  F shim_##name##f(F z) { return (F)my_##name(z); }

TO_REAL(creal) TO_REAL(cimag) TO_REAL(cabs) TO_REAL(carg)
TO_COMPLEX(conj) TO_COMPLEX(cproj) TO_COMPLEX(clog) TO_COMPLEX(clog10) TO_COMPLEX(cexp) TO_COMPLEX(csqrt)
TO_COMPLEX(csinh) TO_COMPLEX(ccosh) TO_COMPLEX(ctanh) TO_COMPLEX(csin) TO_COMPLEX(ccos) TO_COMPLEX(ctan)
Z shim_cpow(Z z, Z w) { return my_cpow(z, w); }
F shim_cpowf(F z, F w) { return (F)my_cpow(z, w); }
