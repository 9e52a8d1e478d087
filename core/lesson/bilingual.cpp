// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/bilingual.h"

#include "core/text.h"

namespace sparkout {

template <>
const StructInfo& tableOf<Bilingual>() {
    static const std::array rows{
        SPARKOUT_FIELD(Bilingual, ru, .label = SPARKOUT_NOOP("Input", "In Russian"), .sparse = true,
                       .hint = SPARKOUT_NOOP(
                           "Input",
                           "With the tags of the help's pages that fetch nothing; formulas stand "
                           "in `<p class=\"formula\">`.")),
        SPARKOUT_FIELD(
            Bilingual, en, .label = SPARKOUT_NOOP("Input", "In English"), .sparse = true,
            .hint = SPARKOUT_NOOP("Input",
                                  "The same. Where one language is missing, the other is shown.")),
    };
    static const StructInfo info =
        makeTable<Bilingual>(SPARKOUT_NOOP("Struct", "Text in both languages"), rows);
    return info;
}

} // namespace sparkout
