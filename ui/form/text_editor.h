// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"

#include <QLineEdit>
#include <QPlainTextEdit>

namespace sparkout {

/// A line of text.
class TextEditor : public FieldEditor {
    Q_OBJECT

public:
    TextEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_line; }
    void show(bool replaced) override;
    void retranslate() override {}
    [[nodiscard]] bool wide() const override { return true; }

private:
    QLineEdit* m_line;
};

/// A text of several lines.
class NotesEditor : public FieldEditor {
    Q_OBJECT

public:
    NotesEditor(const std::string& path, const Field& field, FormModel& model, QWidget* parent);

    [[nodiscard]] QWidget* widget() const override { return m_text; }
    void show(bool replaced) override;
    void retranslate() override;
    [[nodiscard]] bool wide() const override { return true; }
    [[nodiscard]] bool tall() const override { return true; }
    [[nodiscard]] Remark remark() const override;
    [[nodiscard]] QString refusal() const override { return m_refused; }
    void dropRefusal() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take();
    void refuse(const QString& reason);
    [[nodiscard]] static QString tooLong(std::size_t bytes);
    [[nodiscard]] QString stored() const;
    [[nodiscard]] QString typed() const;

    QPlainTextEdit* m_text;
    QString m_refused; ///< why the shown text was refused; empty: accepted
    QString m_kept;    ///< the model's text when that happened
};

} // namespace sparkout
