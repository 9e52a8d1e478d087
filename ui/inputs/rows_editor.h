// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/field_editor.h"

#include <optional>

class QLineEdit;

namespace sparkout {

/// Rows of a few numbers in one line of text: "0 50; 200 80". Empty is not given.
class RowsEditor : public FieldEditor {
    Q_OBJECT

public:
    RowsEditor(const std::string& path, const Field& field, Document& document, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }
    [[nodiscard]] bool empty() const override { return !stored(); }

private:
    void take();
    void refuse(const QString& reason);
    [[nodiscard]] QString text(const NumberRows& rows) const;
    /// The rows of a text; nothing when it has none of the right count.
    [[nodiscard]] std::optional<NumberRows> rowsOf(const QString& text) const;
    [[nodiscard]] const NumberRows& stored() const;

    QLineEdit* m_line;
    QString m_refused; ///< why the text was not taken; empty when it was
    NumberRows m_kept; ///< the document's value when that happened
};

} // namespace sparkout
