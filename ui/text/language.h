// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTranslator>

namespace sparkout {

/// The language of the window: its texts, Qt's texts, and the number format.
class Language : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~Language() override;

    /// "en" or "ru". Every window gets a LanguageChange event.
    void apply(const QString& code);
    [[nodiscard]] const QString& code() const { return m_code; }

private:
    /// The program's texts, with per cent signs kept with their numbers.
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
