# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154
# The tests of core and session under Wine: packaging/windows/try reads this where packaging/windows/build
# --tests made them. What they print is kept in CACHE/try/tests.
#
# Single functions that want a user without rights, a full disk, a pipe among the files or somebody else's
# lock leave themselves out: they are counted. test_safe_file, a program of its own, is built but not
# run by this yet.

test_programs=(core/sparkout_law_tests core/sparkout_counting_tests core/sparkout_core_tests
    ui/sparkout_session_tests ui/sparkout_file_guard_tests)

run_test() { # PROGRAM NAME
    # On Windows Qt's tests write to a file alone, where their output is led elsewhere.
    timeout 1800 wine "$tests/$1.exe" "$2" -o "tests/$2.txt,txt" >"tests/$2.out" 2>&1
}

passed() { # NAME, once it ran; the functions that failed are named
    grep -q '^Totals: [1-9][0-9]* passed, 0 failed' "tests/$1.txt" && return
    grep -A2 '^FAIL!' "tests/$1.txt" || tail -n 3 "tests/$1.txt"
    return 1
}

mkdir -p tests
for program in "${test_programs[@]}"; do # two at a time, as ctest has them on Linux
    mapfile -t names < <(wine "$tests/$program.exe" 2>&1 | tr -d '\r' | sed -n 's/^  //p')
    ((${#names[@]})) || check "$program: has tests" false
    for name in "${names[@]}"; do
        while (($(jobs -rp | grep -vcx "$xvfb") > 1)); do
            wait -n
        done
        run_test "$program" "$name" &
    done
    while (($(jobs -rp | grep -vcx "$xvfb") > 0)); do
        wait -n
    done
    for name in "${names[@]}"; do
        check "$name" passed "$name"
    done
done
awk '/^Totals:/ { tests++; passed += $2; failed += $4; skipped += $6 }
    END { printf "%d tests of %d functions: %d failed, %d left themselves out\n", tests, passed + failed, failed, skipped }' \
    tests/*.txt
grep -h -A1 '^SKIP' tests/*.txt | sed -nE 's/^SKIP *: ([^(]*)\(.*\) (.*)/    \1: \2/p' | tr -d '\r' | sort -u
