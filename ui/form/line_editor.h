// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"
#include "ui/tables/pasted_cells.h"

namespace sparkout {

class CellsLineEdit;

/// A member of several numbers in one line of text. An unreadable text stays, marked with its
/// reason, while the model keeps the last valid value.
class LineEditor : public FieldEditor {
    Q_OBJECT

public:
    LineEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

protected:
    [[nodiscard]] virtual QString storedText() const = 0; ///< text of the model's value
    /// Whether a text means the model's value.
    [[nodiscard]] virtual bool isStored(const QString& text) const = 0;
    /// Passes a text to the model, or returns the reason for refusing it.
    [[nodiscard]] virtual QString accept(const QString& text) = 0;
    /// The text for several pasted cells, or why they are invalid.
    struct CellsText {
        QString text = {};
        QString fault = {};
    };
    [[nodiscard]] virtual CellsText textOf(const PastedCells& cells) const = 0;

private:
    void take();
    void takeCells(const PastedCells& cells); ///< replaces the whole contents, or nothing
    void refuse(const QString& reason);
    void forgetPaste();

    CellsLineEdit* m_line;
    QString m_notPasted; ///< why cells were refused, until the next action
    QString m_refused;   ///< why the text was refused; empty: accepted
    QString m_kept;      ///< the model's value when that happened
};

} // namespace sparkout
