// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>

namespace sparkout {

namespace {

/// Makes the space between a number, or its placeholder, and the per cent sign non-breaking.
QString withPercentsKept(QString text) {
    static const QRegularExpression parted(QStringLiteral("(?<=[\\d}]) %(?![0-9A-Za-z])"));
    return text.contains(u" %") ? text.replace(parted, QStringLiteral("\u00a0%")) : text;
}

} // namespace

/// Includes texts without a translation, as usual in English.
QString Language::Texts::translate(const char* context, const char* source,
                                   const char* disambiguation, int n) const {
    const QString text = QTranslator::translate(context, source, disambiguation, n);
    if (!text.isNull()) {
        return withPercentsKept(text);
    }
    const QString own = QString::fromUtf8(source);
    const QString kept = withPercentsKept(own);
    return kept == own ? text : kept;
}

Language::~Language() {
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
}

void Language::apply(const QString& code) {
    m_code = code;
    QLocale locale = code == u"ru" ? QLocale(QLocale::Russian, QLocale::Russia)
                                   : QLocale(QLocale::English, QLocale::UnitedStates);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(locale);
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    if (m_qt.load(QStringLiteral("qtbase_") + code,
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(&m_qt);
    }
    if (m_own.load(QStringLiteral(":/i18n/sparkout_%1.qm").arg(code))) {
        QCoreApplication::installTranslator(&m_own);
    }
}

} // namespace sparkout
