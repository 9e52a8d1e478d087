/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the GNU library's functions of numbers expect of the rest of that library, for those that
   packaging/windows/build compiles: it is rounded to nearest, nobody asks for exceptions or errno.
 */
#pragma once
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdint.h>

typedef uint32_t u_int32_t;
typedef uint64_t u_int64_t;

#define attribute_hidden
#define SET_RESTORE_ROUND(mode) ((void)0)
#define SET_RESTORE_ROUND_53BIT(mode) ((void)0)
#define libc_feholdexcept_setround(env, mode) ((void)(env))
#define libc_feupdateenv(env) ((void)(env))
#define math_check_force_underflow(x) ((void)(x))
#define math_check_force_underflow_nonneg(x) ((void)(x))
#define math_narrow_eval(x) (x)
#define math_opt_barrier(x) (x)
#define math_force_eval(x) ((void)(x))
#define __glibc_unlikely(x) __builtin_expect((x), 0)
#define __glibc_likely(x) __builtin_expect((x), 1)
#define __always_inline inline __attribute__((always_inline))
#define __set_errno(value) ((void)(value))
#define libm_alias_double(from, to)
#define libm_alias_finite(from, to)
#define libm_alias_double_other(from, to)
#define strong_alias(from, to)
#define weak_alias(from, to)
#define hidden_def(name)
#define hidden_proto(name)
#define LIBM_SVID_COMPAT 0
#define SHLIB_COMPAT(a, b, c) 0
#define versioned_symbol(a, b, c, d)
#define compat_symbol(a, b, c, d)
#define FIX_INT_FP_CONVERT_ZERO 0
#define DIAG_PUSH_NEEDS_COMMENT
#define DIAG_POP_NEEDS_COMMENT
#define DIAG_IGNORE_NEEDS_COMMENT(version, option)
#define DIAG_IGNORE_Os_NEEDS_COMMENT(version, option)
#define HIGH_ORDER_BIT_IS_SET_FOR_SNAN 0
#define TOINT_INTRINSICS 0
#define WANT_ERRNO 0
#define USE_FMA_BUILTIN 0
#define USE_FMAX_BUILTIN 0
#define USE_FMIN_BUILTIN 0
#define __LITTLE_ENDIAN 1234
#define __BIG_ENDIAN 4321
#define __BYTE_ORDER __LITTLE_ENDIAN
#undef LITTLE_ENDIAN
#undef BIG_ENDIAN
#undef BYTE_ORDER
#define LITTLE_ENDIAN 1
#define BIG_ENDIAN 0
#define BYTE_ORDER LITTLE_ENDIAN
#define USE_SQRT_BUILTIN 1
#define sqrt(x) __builtin_sqrt(x)
#define __sqrt(x) __builtin_sqrt(x)
#define __ieee754_sqrt(x) __builtin_sqrt(x)
#define __fma(x, y, z) __builtin_fma(x, y, z)
#define __copysign(x, y) __builtin_copysign(x, y)
#define fabs(x) __builtin_fabs(x)
#undef fpclassify
#undef FP_ZERO
#define FP_ZERO 2
#define fpclassify(x) __builtin_fpclassify(0, 1, 4, 3, 2, (x))

typedef union {
    double value;
    uint64_t word;
    struct {
        uint32_t lsw, msw;
    } parts;
} ieee_double_shape_type;
#define EXTRACT_WORDS(high, low, d)                                                                \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        (high) = u_.parts.msw;                                                                     \
        (low) = u_.parts.lsw;                                                                      \
    } while (0)
#define INSERT_WORDS(d, high, low)                                                                 \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.parts.msw = (high);                                                                     \
        u_.parts.lsw = (low);                                                                      \
        (d) = u_.value;                                                                            \
    } while (0)
#define EXTRACT_WORDS64(i, d)                                                                      \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        (i) = u_.word;                                                                             \
    } while (0)
#define INSERT_WORDS64(d, i)                                                                       \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.word = (i);                                                                             \
        (d) = u_.value;                                                                            \
    } while (0)
#define GET_HIGH_WORD(i, d)                                                                        \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        (i) = u_.parts.msw;                                                                        \
    } while (0)
#define GET_LOW_WORD(i, d)                                                                         \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        (i) = u_.parts.lsw;                                                                        \
    } while (0)
#define SET_HIGH_WORD(d, v)                                                                        \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        u_.parts.msw = (v);                                                                        \
        (d) = u_.value;                                                                            \
    } while (0)
#define SET_LOW_WORD(d, v)                                                                         \
    do {                                                                                           \
        ieee_double_shape_type u_;                                                                 \
        u_.value = (d);                                                                            \
        u_.parts.lsw = (v);                                                                        \
        (d) = u_.value;                                                                            \
    } while (0)

/* Each source is compiled twice, as the library does: for every processor, and for those with FMA.
 */
#define SPARKOUT_JOIN(a, b) a##b
#define SPARKOUT_NAME(a, b) SPARKOUT_JOIN(a, b)
#define OURS(name) SPARKOUT_NAME(SPARKOUT_UNIT, name)
#define __sin OURS(sin)
#define __cos OURS(cos)
#define __tan OURS(tan)
#define __sincos OURS(sincos)
#define __exp OURS(exp)
#define __ieee754_exp(x) exp(x)
#define __log OURS(log)
#define __ieee754_log(x) log(x)
#define __pow OURS(pow)
#define __hypot hypot
#define __cbrt cbrt
#define __exp2 exp2
#define __ieee754_exp2 exp2
#define __log2 OURS(log2)
#define __log1p OURS(log1p)
#define __expm1 OURS(expm1)
#define __erf erf
#define __erfc erfc
#define __log10 log10
#define __ieee754_log10 log10
#define __atan2 OURS(atan2)
#define __ieee754_atan2 OURS(atan2)
#define __exp1 OURS(exp1)
#define __frexp frexp
#define __ldexp ldexp
