# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154
# The tests of core and session under Wine: packaging/windows/try reads this where packaging/windows/build
# --tests made them. What they print is kept in CACHE/try/tests.
#
# Functions about what POSIX alone has are not compiled for Windows: users without rights, modes, a disk that
# is full, pipes and devices among the files, symbolic links, a lock that is taken from a program that
# runs; in their place are some about files that other programs hold open. Functions that leave themselves
# out, as for a processor without AVX2, are counted and named.
#
# Not built for Windows: tests of the window (they want the display, fonts and accessibility of Linux), of
# the command line (packaging/windows/try tries that), and test_crash, test_two_windows and safe_file_faults,
# which kill programs by signals and let system calls fail by strace; packaging/windows/try kills a program
# that saves instead.

test_programs=(core/test_safe_file core/sparkout_law_tests core/sparkout_counting_tests core/sparkout_core_tests
    ui/sparkout_session_tests ui/sparkout_file_guard_tests)

# Built and not run: it reads its books by the Python of Linux, with which Wine 8 joins no pipe. The window's
# workbook is held against that of Linux by try_window.sh.
not_run=test_xlsx_book

run_test() { # PROGRAM NAME
    local -a words=("$2")
    [[ $2 != "$(basename "$1")" ]] || words=() # a program of one test
    # On Windows Qt's tests write to a file alone, where their output is led elsewhere.
    timeout 900 wine "$tests/$1.exe" "${words[@]}" -o "tests/$2.txt,txt" >"tests/$2.out" 2>&1
    echo $? >"tests/$2.status"
}

passed() { # NAME, once it ran; the functions that failed are named
    local status
    status=$(cat "tests/$1.status")
    if grep -q '^Totals: [1-9][0-9]* passed, 0 failed' "tests/$1.txt"; then
        [[ $status != 0 ]] || return 0
        echo "    $1 did not end as it should: $status (124: not at all)"
        return 1
    fi
    grep -A2 '^FAIL!' "tests/$1.txt" || tail -n 3 "tests/$1.txt"
    return 1
}

rm -rf tests
mkdir tests
for program in "${test_programs[@]}"; do # two at a time, as ctest has them on Linux
    if [[ $program == */test_* ]]; then
        names=("$(basename "$program")")
    else
        mapfile -t names < <(wine "$tests/$program.exe" 2>&1 | tr -d '\r' | sed -n 's/^  //p' | grep -vx "$not_run")
    fi
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
echo "    not run: $not_run"
grep -h -A1 '^SKIP' tests/*.txt | sed -nE 's/^SKIP *: ([^(]*)\(.*\) (.*)/    \1: \2/p' | tr -d '\r' | sort -u
