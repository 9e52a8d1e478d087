// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/editors/field_editor.h"

class QLineEdit;

namespace sparkout {

/// A member of several numbers in one line of text. A text it cannot read stays there, marked with
/// its reason, while the document keeps the last good value.
class LineEditor : public FieldEditor {
    Q_OBJECT

public:
    LineEditor(const std::string& path, const Field& field, Document& document, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override;
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override { show(true); }
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }

protected:
    [[nodiscard]] virtual QString storedText() const = 0; ///< of the document's value
    /// Whether a text means the document's value.
    [[nodiscard]] virtual bool isStored(const QString& text) const = 0;
    /// Takes a text to the document, or gives the reason why not.
    [[nodiscard]] virtual QString accept(const QString& text) = 0;

private:
    void take();
    void refuse(const QString& reason);

    QLineEdit* m_line;
    QString m_refused; ///< why the text was not taken; empty when it was
    QString m_kept;    ///< the document's value when that happened
};

} // namespace sparkout
