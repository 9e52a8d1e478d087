// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/institution.h"

#include "core/text.h"
#include "ui/session/kept_texts.h"

#include <array>

namespace sparkout {

using report::Institution;

template <>
const StructInfo& tableOf<Institution>() {
    using T = Institution;
    constexpr Range letters{0, 300};
    static const std::array rows{
        SPARKOUT_FIELD(T, ministry, .label = SPARKOUT_NOOP("Input", "Ministry"), .hard = letters),
        SPARKOUT_FIELD(T, university, .label = SPARKOUT_NOOP("Input", "University"),
                       .hard = letters),
        SPARKOUT_FIELD(T, faculty, .label = SPARKOUT_NOOP("Input", "Faculty or institute"),
                       .hard = letters),
        SPARKOUT_FIELD(T, department, .label = SPARKOUT_NOOP("Input", "University department"),
                       .hard = letters),
        SPARKOUT_FIELD(T, discipline, .label = SPARKOUT_NOOP("Input", "Discipline"),
                       .hard = letters),
        SPARKOUT_FIELD(T, accepted, .label = SPARKOUT_NOOP("Input", "Accepted by (post and name)"),
                       .hard = letters),
        SPARKOUT_FIELD(T, place, .label = SPARKOUT_NOOP("Input", "Town"), .hard = letters),
    };
    static const StructInfo info =
        makeTable<Institution>(SPARKOUT_NOOP("Struct", "Title page"), rows);
    return info;
}

QVariantMap Institution::kept() const {
    return keptTexts(tableOf<Institution>(), this);
}

Institution Institution::fromKept(const QVariantMap& kept) {
    Institution made;
    readKeptTexts(kept, tableOf<Institution>(), &made);
    return made;
}

} // namespace sparkout
