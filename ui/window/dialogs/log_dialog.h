// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

class QPlainTextEdit;
class QPushButton;

namespace sparkout {

class ProgramLog;

/// The messages of the program and Qt since the start, updated live, in a non-modal window.
class LogDialog : public QDialog {
    Q_OBJECT

public:
    /// Shows a remark if there is no log.
    explicit LogDialog(const ProgramLog* log, QWidget* parent = nullptr);

    [[nodiscard]] QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void fill();

    const ProgramLog* m_log;
    QPlainTextEdit* m_text;
    QPushButton* m_copy = nullptr;
    QPushButton* m_close = nullptr;
    QTimer m_pause; ///< collects lines in quick succession
};

} // namespace sparkout
