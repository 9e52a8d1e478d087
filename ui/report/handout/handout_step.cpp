// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/handout_step.h"

#include <QStringList>

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

} // namespace sparkout::report
