// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QVariantMap>

#include <memory>

namespace sparkout {

/// What the program remembers between starts, in an ini file; or, for pictures and tests, only
/// while it runs.
class Settings {
public:
    Settings();                                ///< the user's own
    explicit Settings(const QString& iniFile); ///< another file
    [[nodiscard]] static Settings transient(); ///< nothing is read or written

    [[nodiscard]] QString language() const; ///< "en" or "ru": as chosen, else as the system speaks
    void setLanguage(const QString& code);
    [[nodiscard]] QString theme() const; ///< code of a theme, "system" when none was chosen
    void setTheme(const QString& code);
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);
    [[nodiscard]] QByteArray windowGeometry() const;
    [[nodiscard]] QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

private:
    explicit Settings(std::unique_ptr<QSettings> store) : m_store(std::move(store)) {}
    [[nodiscard]] QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    void set(const QString& key, const QVariant& value);

    std::unique_ptr<QSettings> m_store;
    QVariantMap m_memory;
};

} // namespace sparkout
