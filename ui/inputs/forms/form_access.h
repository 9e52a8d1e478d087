// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>
#include <string_view>

class QWidget;

namespace sparkout {

/// The allowed access to inputs: all of them, or what a step of a lesson allows.
class FormAccess {
    Q_DECLARE_TR_FUNCTIONS(FormAccess)
public:
    FormAccess() = default; ///< every input is free
    /// Locks all inputs while a prediction is awaited.
    FormAccess(const LessonStep& step, bool isAwaited);

    [[nodiscard]] bool isFree() const { return !m_step && !m_isAwaited; } ///< every input is
    [[nodiscard]] Access at(std::string_view path) const;
    /// Whether it, or something below it, may be changed or is shown.
    [[nodiscard]] bool hasFree(std::string_view path) const;
    [[nodiscard]] bool hasShown(std::string_view path) const;
    [[nodiscard]] QString lockText() const; ///< why an input is locked

    /// Locks a widget, or undoes that; what this did not lock stays unchanged.
    static void lock(QWidget& widget, bool locked);
    static bool hide(QWidget& widget, bool hidden); ///< hides or undoes that; true if it was undone

private:
    [[nodiscard]] Access given(std::string_view path) const;

    std::optional<LessonStep> m_step; ///< only its access rules
    bool m_isAwaited = false;
};

using FormAccessPtr = std::shared_ptr<const FormAccess>;

} // namespace sparkout
