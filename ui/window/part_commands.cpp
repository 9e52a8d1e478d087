// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/part_commands.h"

#include "core/units.h"
#include "ui/part/add_surface_dialog.h"
#include "ui/part/dressing_dialog.h"
#include "ui/part/name_dialog.h"
#include "ui/part/times_dialog.h"
#include "ui/session/part_runs.h"

#include <QTimer>

#include <utility>

namespace sparkout {

PartCommands::PartCommands(Document& document, const PartRuns& runs, std::function<bool()> mayLeave,
                           QWidget* window)
    : QObject(window)
    , m_document(document)
    , m_runs(runs)
    , m_edits(document)
    , m_mayLeave(std::move(mayLeave))
    , m_window(window) {}

void PartCommands::show(std::size_t surface) {
    if (surface == m_document.surface()) {
        return;
    }
    if (m_mayLeave() && surface < m_document.surfaceCount()) {
        m_document.showSurface(surface);
    } else {
        emit stayed();
    }
}

void PartCommands::showNext(int by) {
    if (m_edits.canMove(by)) {
        show(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(m_document.surface()) + by));
    }
}

void PartCommands::add(std::optional<std::size_t> step) {
    addAsked(step, false);
}

void PartCommands::duplicate() {
    addAsked({}, true);
}

/// A duplicate that leaves nothing behind needs no question.
void PartCommands::addAsked(std::optional<std::size_t> step, bool isDuplicate) {
    if (!m_edits.canAdd() || !m_mayLeave()) {
        return;
    }
    const auto isFree = [this](const QString& name) {
        return m_edits.isFreeName(name, m_document.surfaceCount());
    };
    AddSurfaceDialog dialog(m_document.state(), m_edits.freeName(), isFree, step, m_window);
    if (isDuplicate) {
        dialog.onlyDuplicate();
    }
    const bool isAsked = !isDuplicate || dialog.hasAnythingToAsk();
    if (!isAsked || dialog.exec() == QDialog::Accepted) {
        const std::vector<std::string> open = dialog.openInputs();
        m_edits.add(dialog.project(), dialog.name(), open, dialog.startsWhenDrawn(), isDuplicate);
        if (!open.empty()) {
            emit begun(open.front());
        }
    }
}

void PartCommands::rename() {
    const std::size_t surface = m_document.surface();
    const auto isFree = [this, surface](const QString& name) {
        return m_edits.isFreeName(name, surface);
    };
    NameDialog dialog(SurfaceEdits::nameOf(m_document.state(), surface), isFree, m_window);
    if (dialog.exec() == QDialog::Accepted) {
        m_edits.rename(surface, dialog.name());
    }
}

void PartCommands::move(int by) {
    m_edits.move(by);
}

void PartCommands::remove() {
    if (m_mayLeave()) {
        m_edits.remove();
    }
}

void PartCommands::editTimes() {
    std::optional<double> cycles_min = 0;
    for (const SurfaceStatus& status : m_runs.statuses()) {
        cycles_min = cycles_min && status.isCompleted()
                         ? std::optional(*cycles_min + status.time_s / units::secondsPerMinute)
                         : std::nullopt;
    }
    const SetupState& state = m_document.state();
    TimesDialog dialog(state.times, state.wear, state.surfaces.size(), cycles_min, m_window);
    if (dialog.exec() == QDialog::Accepted) {
        m_edits.setTimes(dialog.times(), dialog.wear());
    }
}

void PartCommands::showDressing() {
    bool again = m_mayLeave();
    while (again) {
        DressingDialog dialog(m_document.state().setup(), m_window);
        QTimer::singleShot(0, &dialog, &DressingDialog::find); // when it is visible
        dialog.exec();
        again = dialog.wantsWear();
        if (again) {
            editTimes();
        }
    }
}

} // namespace sparkout
