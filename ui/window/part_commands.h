// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/surface_edits.h"

#include <QObject>

#include <functional>
#include <optional>

class QWidget;

namespace sparkout {

class PartRuns;

/// The commands on the surfaces of the set-up, with their dialogs.
class PartCommands : public QObject {
    Q_OBJECT

public:
    /// `mayLeave` commits typed text and asks about refused texts, which belong to their surface;
    /// returns false if the user cancels.
    PartCommands(Document& document, const PartRuns& runs, std::function<bool()> mayLeave,
                 QWidget* window);

    void show(std::size_t surface); ///< makes it current
    void showNext(int by);
    void add(std::optional<std::size_t> step = {}); ///< on a step of the shaft, or as chosen
    void duplicate();                               ///< the one in front
    void rename();
    void move(int by);
    void remove();
    void editTimes();
    void showDressing(); ///< the parts between dressings

signals:
    void stayed();                       ///< the current surface is unchanged
    void begun(const std::string& path); ///< a new surface, whose first input is requested

private:
    void addAsked(std::optional<std::size_t> step, bool isDuplicate);

    Document& m_document;
    const PartRuns& m_runs;
    SurfaceEdits m_edits;
    std::function<bool()> m_mayLeave;
    QWidget* m_window;
};

} // namespace sparkout
