// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/handout_step.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace sparkout::report {

namespace {

struct WishMark {
    const char* letter; ///< prefix of its number
    std::optional<int> StepWish::*member;
};
constexpr WishMark wishMarks[] = {{"", &StepWish::count},   {"z", &StepWish::stage},
                                  {"e", &StepWish::step},   {"r", &StepWish::revolution},
                                  {"k", &StepWish::radius}, {"s", &StepWish::section}};
constexpr std::pair<const char*, Zone> wishZones[] = {
    {"rz1", Zone::rz1}, {"nz", Zone::nz}, {"rz2", Zone::rz2}};

bool readZone(const QString& word, StepWish& wish) {
    for (const auto& [name, zone] : wishZones) {
        if (word == QLatin1StringView(name)) {
            const bool first = !wish.zone;
            wish.zone = zone;
            return first;
        }
    }
    return false;
}

bool readMark(const QString& word, StepWish& wish) {
    for (const auto& [letter, member] : wishMarks) {
        const QLatin1StringView begin(letter);
        bool read = false;
        const int number = word.startsWith(begin) ? word.mid(begin.size()).toInt(&read) : 0;
        if (read && number >= 0 && word.back().isDigit()) {
            const bool first = !(wish.*member);
            wish.*member = number;
            return first;
        }
    }
    return false;
}

bool fits(const Place& at, const StepWish& wish) {
    const auto is = [](const std::optional<int>& wanted, int value) {
        return !wanted || *wanted == value;
    };
    return (!wish.zone || *wish.zone == at.zone)
           && (!wish.section || (at.zone == Zone::section && *wish.section == at.section))
           && is(wish.stage, at.stage) && is(wish.count, at.cycleCount)
           && is(wish.step, static_cast<int>(at.step)) && is(wish.revolution, at.revolution);
}

} // namespace

std::optional<StepWish> readStepWish(const QString& text) {
    StepWish wish;
    for (const QString& word : text.toLower().split(u',')) {
        const QString trimmed = word.trimmed();
        if (!readZone(trimmed, wish) && !readMark(trimmed, wish)) {
            return {};
        }
    }
    return wish;
}

std::optional<HandoutStep> findStep(const Trajectory& trajectory, const StepWish& wish) {
    std::optional<HandoutStep> found;
    double deepest = -1;
    for (std::size_t i = 0; i < trajectory.passes.size(); ++i) {
        if (!fits(trajectory.passes[i].place, wish)) {
            continue;
        }
        for (int k = 0; k < trajectory.radii; ++k) {
            const double a = visitAt(trajectory, {i, k})->actual_mm;
            if ((!wish.radius || *wish.radius == k) && a > deepest) {
                deepest = a;
                found = HandoutStep{i, k};
            }
        }
    }
    return found;
}

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
