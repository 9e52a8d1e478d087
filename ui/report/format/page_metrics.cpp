// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/page_metrics.h"

namespace sparkout::report {

const PageMetrics& metricsOf(PageStyle style) {
    // The left margin is for filing. Head and foot have a line of text and a rule.
    static const PageMetrics sheet{.body = 9,
                                   .small = 7.5,
                                   .heading = 11,
                                   .title = 15,
                                   .cell = 9,
                                   .cellHead = 7.5,
                                   .formula = 9.5,
                                   .lineSpacing = 1,
                                   .indent = 0,
                                   .apart = 0,
                                   .head = 180,
                                   .foot = 180,
                                   .margins_mm = {18, 12, 12, 12}};
    // The page number takes 10 of the 20 mm below the text.
    static const PageMetrics standard{.body = 12,
                                      .small = 12,
                                      .heading = 14,
                                      .title = 16,
                                      .cell = 10,
                                      .cellHead = 9,
                                      .formula = 12,
                                      .lineSpacing = 1.5,
                                      .indent = 354,
                                      .apart = 100,
                                      .head = 0,
                                      .foot = 283,
                                      .margins_mm = {30, 20, 15, 10}};
    return style == PageStyle::sheet ? sheet : standard;
}

} // namespace sparkout::report
