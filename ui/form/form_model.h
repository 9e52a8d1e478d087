// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QObject>

#include <functional>
#include <string>

namespace sparkout {

/// The values that a form shows and changes, each at the path of its member.
class FormModel : public QObject {
    Q_OBJECT

public:
    using Change = std::function<void(void* owner)>;

    using QObject::QObject;

    /// The struct with the member at a path; null: it is not there.
    [[nodiscard]] virtual const void* ownerOf(const std::string& path) const = 0;
    /// Changes the struct with the member at a path. In a history, successive changes at the same
    /// path are one step if they merge.
    virtual void change(const std::string& path, const Change& set, bool merges) = 0;
    /// Whether undo and redo go through all changes; without a history each field has its own.
    [[nodiscard]] virtual bool hasHistory() const = 0;
    virtual void endMerge() {} ///< makes the next change a step of its own

    /// Whether a change would violate no rule that is currently met.
    [[nodiscard]] virtual bool fits(const std::string&, const Change&) const { return true; }
    /// The project whose inputs the values are; null: they are no inputs.
    [[nodiscard]] virtual const Project* project() const { return nullptr; }
    /// Whether a number is still to be entered.
    [[nodiscard]] virtual bool isOpen(const std::string&) const { return false; }
    /// Marks a number as still to be entered.
    virtual void withdraw(const std::string&) {}

signals:
    void changed(); ///< another value
    void saved();
};

} // namespace sparkout
