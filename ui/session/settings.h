// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/company.h"
#include "ui/session/settings_file.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVariantMap>

#include <memory>

namespace sparkout {

/// Settings that the program keeps between starts or, for pictures and tests, only while it runs.
/// An invalid value counts as not set.
class Settings {
public:
    Settings();                                ///< the user's settings file
    explicit Settings(const QString& file);    ///< another file
    [[nodiscard]] static Settings transient(); ///< no file is read or written

    [[nodiscard]] QString
    language() const; ///< "en" or "ru": as chosen, otherwise the language of the system
    void setLanguage(const QString& code);
    [[nodiscard]] QString theme() const; ///< "system", "light", "dark" or "contrast"
    void setTheme(const QString& theme);
    [[nodiscard]] int fontSize() const; ///< in per cent of the system's font size
    void setFontSize(int percent);
    [[nodiscard]] bool stockOnDiameter() const; ///< whether inputs state the stock on the diameter
    void setStockOnDiameter(bool onDiameter);
    [[nodiscard]] bool allInputs() const; ///< whether all inputs are shown, not only the usual ones
    void setAllInputs(bool all);
    [[nodiscard]] bool tourSeen() const; ///< whether the tour of the window was shown
    void setTourSeen();
    [[nodiscard]] QString handout() const; ///< options of the last course hand-out, as text
    void setHandout(const QString& words);
    [[nodiscard]] Company company() const; ///< company in the heads of documents
    void setCompany(const Company& company);
    [[nodiscard]] QVariantMap titlePage() const; ///< texts of the title page of reports, by key
    void setTitlePage(const QVariantMap& texts);
    /// Returns the name and group of the last student.
    [[nodiscard]] QStringList student() const;
    void setStudent(const QString& name, const QString& group);
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);
    [[nodiscard]] QStringList recentFiles() const; ///< newest first
    void addRecentFile(const QString& path);
    void setRecentFiles(const QStringList& paths);
    [[nodiscard]] QByteArray windowGeometry() const;
    [[nodiscard]] QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    [[nodiscard]] QByteArray dialogGeometry(const QString& name) const;
    void setDialogGeometry(const QString& name, const QByteArray& geometry);
    /// Returns the keys of the hidden columns of a table, which is identified by its object name.
    [[nodiscard]] QStringList hiddenColumns(const QString& table) const;
    void setHiddenColumns(const QString& table, const QStringList& keys);

    /// Returns the folder of the file and of the user's other files; empty: nothing is kept.
    [[nodiscard]] const QString& folder() const { return m_folder; }
    std::optional<FileError> flush() { return m_file->flush(); } ///< writes all changes now
    /// Returns the file itself, with its damaged copies, reading errors and refusals.
    [[nodiscard]] SettingsFile& file() const { return *m_file; }

    static constexpr int recentFilesKept = 9; ///< one for each digit 1…9

private:
    [[nodiscard]] QString oneOf(const QString& key, const QStringList& allowed) const;

    std::unique_ptr<SettingsFile> m_file;
    QString m_folder;
};

} // namespace sparkout
