// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/editors/field_editor.h"

#include <QCheckBox>
#include <QComboBox>

namespace sparkout {

/// A combo box that passes the wheel to its page, so that scrolling changes no value.
class StillComboBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override;
};

/// An editor of an enumeration.
class ChoiceEditor : public FieldEditor {
    Q_OBJECT

public:
    ChoiceEditor(const std::string& path, const Field& field, Document& document, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_box; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }

private:
    void fill();

    StillComboBox* m_box;
};

/// Yes or no.
class BooleanEditor : public FieldEditor {
    Q_OBJECT

public:
    BooleanEditor(const std::string& path, const Field& field, Document& document, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_box; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }

private:
    QCheckBox* m_box;
};

} // namespace sparkout
