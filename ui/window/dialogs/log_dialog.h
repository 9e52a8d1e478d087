// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

class QPlainTextEdit;
class QPushButton;

namespace sparkout {

class ProgramLog;

/// What the program and Qt reported since the start, beside the work; follows what comes.
class LogDialog : public QDialog {
    Q_OBJECT

public:
    /// Without a log it says so.
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
    QTimer m_pause; ///< gathers lines that come together
};

} // namespace sparkout
