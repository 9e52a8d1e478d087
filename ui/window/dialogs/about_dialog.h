// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <QTimer>

#include <vector>

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

/// The components of the program and the full texts of their licences.
class LicencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit LicencesDialog(QWidget* parent = nullptr);

    struct Component {
        QString name;
        QString licence; ///< its SPDX identifier
        QString copyright;
    };
    [[nodiscard]] static std::vector<Component> components(); ///< Sparkout first

    /// The licences that an expression of SPDX names, one after the other; empty where one is
    /// missing.
    [[nodiscard]] static QString textsOf(const QString& expression);
};

/// The program, its version, and the versions of its libraries.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* parent = nullptr);

    /// A line each: program, engine, libraries, compiler, system.
    [[nodiscard]] static QString versions();
};

} // namespace sparkout
