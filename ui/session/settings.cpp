// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/settings.h"

#include <QDir>
#include <QLocale>

namespace sparkout {

namespace {

const QString languageKey = QStringLiteral("language");
const QString themeKey = QStringLiteral("theme");
const QString folderKey = QStringLiteral("lastFolder");
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

} // namespace

Settings::Settings()
    : Settings(std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                           QStringLiteral("sparkout"),
                                           QStringLiteral("sparkout"))) {}

Settings::Settings(const QString& iniFile)
    : Settings(std::make_unique<QSettings>(iniFile, QSettings::IniFormat)) {}

Settings Settings::transient() {
    return Settings(std::unique_ptr<QSettings>());
}

QString Settings::language() const {
    const QString chosen = value(languageKey).toString();
    if (chosen == u"en" || chosen == u"ru") {
        return chosen;
    }
    return QLocale::system().language() == QLocale::Russian ? QStringLiteral("ru")
                                                            : QStringLiteral("en");
}

void Settings::setLanguage(const QString& code) {
    set(languageKey, code);
}

QString Settings::theme() const {
    return value(themeKey, QStringLiteral("system")).toString();
}

void Settings::setTheme(const QString& code) {
    set(themeKey, code);
}

QString Settings::lastFolder() const {
    return value(folderKey, QDir::homePath()).toString();
}

void Settings::setLastFolder(const QString& folder) {
    set(folderKey, folder);
}

QByteArray Settings::windowGeometry() const {
    return value(geometryKey).toByteArray();
}

QByteArray Settings::windowState() const {
    return value(stateKey).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
    set(geometryKey, geometry);
    set(stateKey, state);
}

QVariant Settings::value(const QString& key, const QVariant& otherwise) const {
    return m_store ? m_store->value(key, otherwise) : m_memory.value(key, otherwise);
}

void Settings::set(const QString& key, const QVariant& value) {
    if (m_store) {
        m_store->setValue(key, value);
    } else {
        m_memory.insert(key, value);
    }
}

} // namespace sparkout
