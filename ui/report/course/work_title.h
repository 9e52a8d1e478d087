// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/bilingual.h"

#include <QString>

namespace sparkout::report {

/// The title of a lesson, "Work 2. Programmed and actual feed", split into number and name.
struct WorkTitle {
    explicit WorkTitle(const Bilingual& title); ///< translated

    QString number; ///< "2"; empty: the title has none
    QString name;

    [[nodiscard]] QString inFull() const; ///< unchanged
private:
    QString m_full;
};

} // namespace sparkout::report
