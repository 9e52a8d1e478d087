// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"

#include <array>
#include <optional>
#include <vector>

class QLabel;

namespace sparkout {

class NumberField;

/// Lowest, highest and step of a machine's range: three numbers, or none.
class RangeEditor : public FieldEditor {
    Q_OBJECT

public:
    RangeEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_body; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override;
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

private:
    using Values = std::optional<std::vector<double>>;

    void take();
    /// The reason why the three are not a range; empty if they are.
    [[nodiscard]] QString fault() const;
    [[nodiscard]] const Values& stored() const;

    QWidget* m_body;
    std::array<NumberField*, 3> m_fields{};
    std::array<QLabel*, 3> m_names{}; ///< labels before the fields
    QLabel* m_unit;
    Values m_kept; ///< the document's value when the texts were last in order
};

} // namespace sparkout
