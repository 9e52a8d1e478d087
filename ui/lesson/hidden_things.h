// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QObject>

#include <functional>
#include <set>
#include <vector>

class QAction;

namespace sparkout {

class LessonRun;

/// What of the window a step of a lesson takes away: each view, panel and command is entered once
/// with the things whose absence takes it away, and comes back when none of them is hidden.
class HiddenThings : public QObject {
    Q_OBJECT

public:
    using Things = std::set<Hideable>;

    using QObject::QObject;

    void add(Things with, std::function<void(bool hidden)> hide);
    void add(Things with, QAction* command); ///< neither in a menu nor by keys

    /// What a step hides, and what would show it in another way: reports and exports tell what the
    /// views and the verdict do, remedies stand in the verdict; reports, formulas and compared runs
    /// state inputs that are hidden.
    [[nodiscard]] static Things of(const LessonStep& step);
    /// The same of the step in front of a work, and what tells what other steps of it ask to
    /// predict.
    [[nodiscard]] static Things of(const LessonRun& run);
    /// Where a figure is to be read, or seen.
    [[nodiscard]] static Things telling(const Figure& figure);
    void hide(const Things& things);
    [[nodiscard]] bool isHidden(Hideable thing) const { return m_hidden.contains(thing); }

private:
    struct Entry {
        Things with;
        std::function<void(bool hidden)> hide;
        bool isHidden = false;
    };
    std::vector<Entry> m_entries;
    Things m_hidden;
};

} // namespace sparkout
