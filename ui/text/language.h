// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTranslator>

namespace sparkout {

/// The language of the window: its texts, Qt's own texts, and how numbers are written.
class Language : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~Language() override;

    /// "en" or "ru". Every window gets a LanguageChange event.
    void apply(const QString& code);
    [[nodiscard]] const QString& code() const { return m_code; }

private:
    QString m_code;
    QTranslator m_own;
    QTranslator m_qt;
};

} // namespace sparkout
