// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QObject>

#include <functional>
#include <string>

namespace sparkout {

/// The struct that a form shows and changes, with all that is below it.
class FormModel : public QObject {
    Q_OBJECT

public:
    using Change = std::function<void(void* root)>;

    explicit FormModel(const StructInfo& table, QObject* parent = nullptr)
        : QObject(parent), m_table(table) {}

    [[nodiscard]] const StructInfo& table() const { return m_table; }
    [[nodiscard]] virtual const void* root() const = 0;
    /// Changes it. In a history, changes in a row under the same key are one step; a change without
    /// a key is a step of its own.
    virtual void change(const std::string& key, const Change& set) = 0;
    /// Whether undo and redo go through all changes; without a history each field has its own.
    [[nodiscard]] virtual bool hasHistory() const = 0;

signals:
    void changed(); ///< another value

private:
    const StructInfo& m_table;
};

} // namespace sparkout
