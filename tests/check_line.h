// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTest>

#include <algorithm>

namespace sparkout {

/// One line of the table docs/reliability.md: `CHECK nn value limit PASS|FAIL  note`. The limit is
/// that of the check, not of the test around it: where times are watched, a test goes red at four
/// times a target alone (tries.h).
inline void checkLine(const char* number, double value, double limit, bool passed,
                      const QString& note) {
    qInfo("CHECK %s %.6g %.6g %s  %s", number, value, limit, passed ? "PASS" : "FAIL",
          qPrintable(note));
}

/// How many are asked: the long tests, which the table is made of, owe what the check was set; the
/// ordinary ones and those under the sanitizers do fewer.
inline double asked(double written, double done) {
    const bool whole =
        qEnvironmentVariableIsSet("SPARKOUT_LONG") && !qEnvironmentVariableIsSet("SPARKOUT_QUICK");
    return whole ? written : std::min(written, done);
}

/// Functions of a class of tests, row by row, and those of them that held: to be counted in its
/// cleanup() and printed in its cleanupTestCase().
class HeldFunctions {
public:
    void count() {
        ++m_run;
        m_held += !QTest::currentTestFailed();
    }
    void print(const char* number, const QString& note) const {
        checkLine(number, m_held, m_run, m_held == m_run, note);
    }

private:
    int m_run = 0, m_held = 0;
};

/// What a time is to its target, for the line that prints it: a figure beyond it may stand in a
/// test that passes.
inline const char* beside(double value, double target) {
    return value <= target       ? "within the target"
           : value <= 4 * target ? "beyond the target, within the four times it that a test allows"
                                 : "beyond four times the target";
}

} // namespace sparkout
