// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace sparkout {

class Document;
class Settings;
struct MeasuredSource;

/// The commands that bring measurements into the project: from a file, from the clipboard.
class MeasuredImport : public QObject {
    Q_OBJECT

public:
    MeasuredImport(Document& document, Settings& settings, QWidget* window);

    void importFile(); ///< asks for the file
    void importFrom(const QString& path);
    void paste();
    void take(MeasuredSource source); ///< asks how to read it

signals:
    void imported();

private:
    void say(const QString& title, const QString& text);

    Document& m_document;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
