// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"
#include "ui/report/format/text_box.h"

#include <QSizeF>

#include <vector>

namespace sparkout::report {

/// A title page laid out.
class TitleSheet {
public:
    struct Line {
        TextBox box;
        double x, y;
    };
    /// The institution at the top, the kind and title in the middle, the people at the right, place
    /// and year at the foot.
    [[nodiscard]] static std::vector<Line> lines(const TitlePage& title, QSizeF area);
};

} // namespace sparkout::report
