// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/answer.h"

namespace sparkout {

template <>
const StructInfo& tableOf<Answer>() {
    constexpr double largest = 1e9;
    static const std::array rows{
        SPARKOUT_FIELD(Answer, setup, .label = "Set-up", .sparse = true,
                       .hint = "The project as the student has set it, as in a project file."),
        SPARKOUT_FIELD(Answer, number, .label = "Number", .hard = {-largest, largest},
                       .nullMeaning = "none is asked for"),
        SPARKOUT_FIELD(Answer, curve, .label = "Curve", .hard = {-largest, largest},
                       .nullMeaning = "none is asked for", .hint = "Rows of x and y, x rising."),
        SPARKOUT_FIELD(Answer, order, .label = "Order", .hard = {0, 100000},
                       .nullMeaning = "none is asked for",
                       .hint = "Zones or sections from 0, the largest first."),
        SPARKOUT_FIELD(Answer, chosen, .label = "Options chosen", .hard = {1, 20},
                       .nullMeaning = "none is asked for", .hint = "From 1."),
        SPARKOUT_FIELD(Answer, text, .label = "Text", .sparse = true),
    };
    static const StructInfo info = makeTable<Answer>("Answer", rows);
    return info;
}

} // namespace sparkout
