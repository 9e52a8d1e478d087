// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVariant>

#include <functional>
#include <string>
#include <vector>

namespace sparkout {

/// A combo box that passes the wheel to its page, so that scrolling changes no value.
class StillComboBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// An editor of a value that is one of several.
class ChoiceEditor : public FieldEditor {
    Q_OBJECT

public:
    struct Option {
        QString text;
        QVariant value;
    };
    /// What is offered, how the value is read and set, and the text of one that is not offered.
    struct Choosing {
        std::function<std::vector<Option>()> options;
        std::function<QVariant(const void* owner)> get;
        std::function<void(void* owner, const QVariant& chosen)> put;
        std::function<QString(const QVariant& value)> text = {};
    };
    /// The choices of an enumeration.
    [[nodiscard]] static Choosing choicesOf(const Field& field);

    ChoiceEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent,
                 Choosing by);

    [[nodiscard]] QWidget* widget() const override { return m_box; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }

private:
    Choosing m_by;
    QComboBox* m_box;
};

/// Yes or no.
class BooleanEditor : public FieldEditor {
    Q_OBJECT

public:
    BooleanEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_box; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }

private:
    QCheckBox* m_box;
};

} // namespace sparkout
