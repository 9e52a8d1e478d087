/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints a digest of each function over a million arguments; packaging/windows/try compares those of
   Windows with those of Linux. To be compiled with -fno-builtin. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint64_t state = 88172645463325252u;

static double between(double low, double high) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return low + (high - low) * ((double)(state >> 11) * 0x1p-53);
}

static uint64_t digest;

static void add(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    digest = (digest ^ bits) * 0x100000001b3u;
    digest ^= digest >> 29;
}

static void print(const char* name, double low, double high) {
    printf("%s %g..%g %08x%08x\n", name, low, high, (unsigned)(digest >> 32), (unsigned)digest);
    digest = 1;
}

static void one(const char* name, double (*function)(double), double low, double high) {
    for (int i = 0; i < 1000000; ++i)
        add(function(between(low, high)));
    print(name, low, high);
}

static void two(const char* name, double (*function)(double, double), double low, double high) {
    for (int i = 0; i < 1000000; ++i) {
        const double x = between(low, high);
        add(function(x, between(low, high)));
    }
    print(name, low, high);
}

int main(void) {
    one("sin", sin, -10, 10);
    one("sin", sin, -1e5, 1e5);
    one("sin", sin, -1e15, 1e15);
    one("cos", cos, -10, 10);
    one("cos", cos, -1e5, 1e5);
    one("tan", tan, -10, 10);
    one("exp", exp, -20, 20);
    one("exp", exp, -700, 700);
    one("log", log, 1e-6, 10);
    one("log", log, 0.5, 1.5);
    one("log10", log10, 1e-6, 100);
    one("log2", log2, 1e-6, 100);
    one("log1p", log1p, -0.9, 5);
    one("expm1", expm1, -3, 3);
    one("exp2", exp2, -20, 20);
    one("cbrt", cbrt, -100, 100);
    one("erf", erf, -3, 3);
    one("erfc", erfc, -3, 6);
    two("pow", pow, 1e-3, 10);
    two("pow", pow, 0.1, 2);
    two("hypot", hypot, -100, 100);
    two("atan2", atan2, -10, 10);
    two("fmod", fmod, 0.1, 100);
    two("remainder", remainder, 0.1, 100);
    return 0;
}
