// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/bilingual.h"

namespace sparkout {

template <>
const StructInfo& tableOf<Bilingual>() {
    static const std::array rows{
        SPARKOUT_FIELD(Bilingual, ru, .label = "In Russian", .sparse = true,
                       .hint =
                           "With the tags of the help's pages that fetch nothing; formulas stand "
                           "in `<p class=\"formula\">`."),
        SPARKOUT_FIELD(Bilingual, en, .label = "In English", .sparse = true,
                       .hint = "The same. Where one language is missing, the other is shown."),
    };
    static const StructInfo info = makeTable<Bilingual>("Text in both languages", rows);
    return info;
}

} // namespace sparkout
