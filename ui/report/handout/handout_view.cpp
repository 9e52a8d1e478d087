// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/handout_view.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace sparkout::report {

namespace {

constexpr std::array viewRows{
    HandoutViewRow{HandoutView::feeds, "feeds",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds around the step, with E1…E5")},
    HandoutViewRow{HandoutView::cycle, "cycle",
                   QT_TRANSLATE_NOOP("HandoutView", "Feeds over the whole cycle")},
    HandoutViewRow{HandoutView::profiles, "profiles",
                   QT_TRANSLATE_NOOP("HandoutView", "Zone profiles at the end")},
    HandoutViewRow{HandoutView::limits, "limits",
                   QT_TRANSLATE_NOOP("HandoutView", "Actual feed under its limits")},
    HandoutViewRow{HandoutView::grid, "grid",
                   QT_TRANSLATE_NOOP("HandoutView", "Grid of dynamic programming")},
};

} // namespace

std::span<const HandoutViewRow> handoutViews() {
    return viewRows;
}

std::optional<std::set<HandoutView>> readHandoutViews(const QString& text) {
    std::set<HandoutView> views;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        const auto row = std::ranges::find_if(viewRows, [&](const HandoutViewRow& r) {
            return word.trimmed() == QLatin1StringView(r.key);
        });
        if (row == viewRows.end()) {
            return {};
        }
        views.insert(row->view);
    }
    return views;
}

QString handoutViewText(const std::set<HandoutView>& views) {
    QStringList keys;
    for (const HandoutViewRow& row : viewRows) {
        if (views.contains(row.view)) {
            keys << QString::fromLatin1(row.key);
        }
    }
    return keys.join(u',');
}

} // namespace sparkout::report
