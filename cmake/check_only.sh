#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Launches the compiler of the preset `lint`: it checks a source and makes no code of it, which
# spares a tenth to a fifth of the time. Precompiled headers are made as ever.
case " $* " in *" -emit-pch "*) exec "$@" ;; esac
for argument; do
    [ "$before" != -o ] || object=$argument
    before=$argument
done
"$@" -fsyntax-only && : >"$object"
