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

/// Hides parts of the window in a lesson's step: each view, panel and command is registered once
/// with the things that hide it, and reappears when none of them is hidden.
class HiddenThings : public QObject {
    Q_OBJECT

public:
    using Things = std::set<Hideable>;

    using QObject::QObject;

    void add(Things with, std::function<void(bool hidden)> hide);
    void add(Things with, QAction* command); ///< removes it from menus and shortcuts

    /// The things that a step hides, including other ways to see them: reports and exports repeat
    /// the views and the verdict, remedies belong to the verdict; reports, formulas and compared
    /// runs state hidden inputs.
    [[nodiscard]] static Things of(const LessonStep& step);
    /// Those of a work's current step, including what would reveal predictions of its other steps.
    [[nodiscard]] static Things of(const LessonRun& run);
    /// The things that show a figure.
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
