// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QtGlobal>

#include <rapidcheck.h>

#include <algorithm>
#include <functional>

/// How many random inputs a law is held against: `ordinary`, a twentieth of it but at least 20
/// under the sanitizers (SPARKOUT_QUICK). They are the same inputs in every run, so that a red test
/// stays red until it is mended; the long tests (SPARKOUT_LONG) draw new ones, four times as many.
/// RC_PARAMS, when set, is taken as it is. Call it before the first check: rapidcheck reads its
/// settings once.
inline void setRapidcheckRuns(int ordinary) {
    if (qEnvironmentVariableIsSet("RC_PARAMS")) {
        return;
    }
    const bool quick = qEnvironmentVariableIsSet("SPARKOUT_QUICK");
    if (qEnvironmentVariableIsSet("SPARKOUT_LONG") && !quick) {
        qputenv("RC_PARAMS", "max_success=" + QByteArray::number(4 * ordinary));
        return;
    }
    qputenv("RC_PARAMS", "seed=20261121 max_success="
                             + QByteArray::number(quick ? std::max(ordinary / 20, 20) : ordinary));
}

namespace sparkout::fixtures {

inline bool holds(const char* law, const std::function<void()>& check) {
    return rc::check(law, check);
}

} // namespace sparkout::fixtures
