/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions by their usual names, for the processor at hand, as the GNU library picks them. */
static int hasFma(void) {
    static int known = -1;
    if (known < 0)
        known = __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
    return known;
}

#define ONE(name)                                                                                  \
    double every_##name(double);                                                                   \
    double fma_##name(double);                                                                     \
    double name(double x) { return hasFma() ? fma_##name(x) : every_##name(x); }
#define TWO(name)                                                                                  \
    double every_##name(double, double);                                                           \
    double fma_##name(double, double);                                                             \
    double name(double x, double y) { return hasFma() ? fma_##name(x, y) : every_##name(x, y); }

ONE(sin)
ONE(cos)
ONE(tan)
ONE(exp)
ONE(log)
ONE(log2)
ONE(log1p)
ONE(expm1)
TWO(pow)
TWO(atan2)

void every_sincos(double, double*, double*);
void fma_sincos(double, double*, double*);
void sincos(double x, double* s, double* c) {
    if (hasFma())
        fma_sincos(x, s, c);
    else
        every_sincos(x, s, c);
}

/* These stand in one object with the compiler's own sincos(), which is not to come along. */
long double sinl(long double);
long double cosl(long double);
void sincosl(long double x, long double* s, long double* c) {
    *s = sinl(x);
    *c = cosl(x);
}
void sincosf(float x, float* s, float* c) {
    double sine, cosine;
    sincos(x, &sine, &cosine);
    *s = (float)sine;
    *c = (float)cosine;
}
