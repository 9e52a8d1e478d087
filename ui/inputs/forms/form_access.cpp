// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/form_access.h"

#include <QGroupBox>
#include <QVariant>

#include <algorithm>

namespace sparkout {

namespace {

constexpr const char* lockedProperty = "lockedByLesson";
constexpr const char* hiddenProperty = "hiddenByLesson";

/// The ticks of boxes disable their contents.
bool isInUntickedBox(const QWidget& widget) {
    for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
        const auto* box = qobject_cast<const QGroupBox*>(up);
        if (box && box->isCheckable() && !box->isChecked()) {
            return true;
        }
    }
    return false;
}

bool isBelowPath(std::string_view path, std::string_view above) {
    return path.starts_with(above) && path.size() > above.size() && path[above.size()] == '/';
}

} // namespace

FormAccess::FormAccess(const LessonStep& step, bool isAwaited)
    : m_step(LessonStep{}), m_isAwaited(isAwaited) {
    m_step->others = step.others;
    m_step->inputs = step.inputs;
}

Access FormAccess::given(std::string_view path) const {
    return m_step ? accessTo(*m_step, path) : Access::free;
}

Access FormAccess::at(std::string_view path) const {
    const Access access = given(path);
    return m_isAwaited && access == Access::free ? Access::locked : access;
}

bool FormAccess::hasFree(std::string_view path) const {
    return at(path) == Access::free
           || (!m_isAwaited && m_step
               && std::any_of(
                   m_step->inputs.begin(), m_step->inputs.end(), [path](const InputAccess& each) {
                       return each.access == Access::free && isBelowPath(each.path, path);
                   }));
}

bool FormAccess::hasShown(std::string_view path) const {
    return given(path) != Access::hidden
           || (m_step
               && std::any_of(
                   m_step->inputs.begin(), m_step->inputs.end(), [path](const InputAccess& each) {
                       return each.access != Access::hidden && isBelowPath(each.path, path);
                   }));
}

void FormAccess::lock(QWidget& widget, bool locked) {
    if (locked) {
        widget.setEnabled(false);
    } else if (widget.property(lockedProperty).toBool()) {
        widget.setEnabled(!isInUntickedBox(widget));
    }
    widget.setProperty(lockedProperty, locked);
}

bool FormAccess::hide(QWidget& widget, bool hidden) {
    const bool wasHidden = widget.property(hiddenProperty).toBool();
    widget.setProperty(hiddenProperty, hidden);
    if (hidden || wasHidden) {
        widget.setVisible(!hidden);
    }
    return wasHidden && !hidden;
}

QString FormAccess::lockText() const {
    return m_isAwaited ? tr("Locked until the prediction is given.")
                       : tr("Locked in this step of the laboratory work.");
}

} // namespace sparkout
