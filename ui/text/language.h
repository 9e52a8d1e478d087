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
    /// The program's own texts, in which a percent sign stays with its number.
    class Texts : public QTranslator {
    public:
        [[nodiscard]] QString translate(const char* context, const char* source,
                                        const char* disambiguation, int n) const override;
    };

    QString m_code;
    Texts m_own;
    QTranslator m_qt;
};

} // namespace sparkout
