// SPDX-License-Identifier: GPL-3.0-or-later
// Where a program is entered from outside. Code compiled with -fcf-protection marks each place that
// may be jumped to; the start files of Debian's C library (Scrt1.o, crti.o) are compiled without.
// The loader jumps here instead, and from here the jump is a direct one, which needs no mark.
asm(R"(
    .text
    .globl sparkout_start, sparkout_init, sparkout_fini
    .hidden sparkout_start, sparkout_init, sparkout_fini
    .type sparkout_start, @function
    .type sparkout_init, @function
    .type sparkout_fini, @function
sparkout_start:
    endbr64
    jmp _start
sparkout_init:
    endbr64
    jmp _init
sparkout_fini:
    endbr64
    jmp _fini
)");
