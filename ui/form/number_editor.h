// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"

namespace sparkout {

class ValueSlider;

/// An editor for numbers, whole or not, required or optional.
class NumberEditor : public FieldEditor {
    Q_OBJECT

public:
    NumberEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent,
                 SpecOf spec = {});

    [[nodiscard]] QWidget* widget() const override { return m_field; }
    [[nodiscard]] QWidget* slider() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override { return m_field->remark(); }
    [[nodiscard]] QString refusal() const override;
    void dropRefusal() override;
    void setIssue(const Remark& issue) override { m_field->setIssue(issue); }
    [[nodiscard]] bool empty() const override { return !m_field->value(); }

private:
    [[nodiscard]] std::optional<double> stored() const;
    void store(std::optional<double> value);
    void addSlider(QWidget* parent);

    SpecOf m_spec;
    NumberField* m_field;
    ValueSlider* m_slider = nullptr;
};

} // namespace sparkout
