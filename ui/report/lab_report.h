// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/work.h"
#include "ui/report/course_handout.h"
#include "ui/report/format/report.h"
#include "ui/report/paper_writer.h"

#include <QDate>
#include <QString>

#include <functional>
#include <set>

namespace sparkout::report {

/// The options of the course papers, besides a lesson or a work.
struct PaperWish {
    Institution institution;
    QString file; ///< path of the lesson or work; may be empty
    QDate date;
    std::set<HandoutView> figures{HandoutView::cycle, HandoutView::profiles};
    std::function<void()> breathe = [] {}; ///< called between runs and figures
};

/// The report of a laboratory work in the order of ГОСТ 7.32, from the student's file: it shows
/// nothing that the file does not, and results only after all predictions are handed in. Its
/// conclusion is the answer to the last step in words; without one there are blank lines. In the
/// window's thread.
[[nodiscard]] Report labReport(const Work& work, const PaperWish& wish);

} // namespace sparkout::report
