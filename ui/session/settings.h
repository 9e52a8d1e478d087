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

/// What the program remembers between starts; or, for pictures and tests, only while it runs. A
/// value that makes no sense counts as not set.
class Settings {
public:
    Settings();                                ///< the user's own
    explicit Settings(const QString& file);    ///< another file
    [[nodiscard]] static Settings transient(); ///< nothing is read or written

    [[nodiscard]] QString language() const; ///< "en" or "ru": as chosen, else as the system speaks
    void setLanguage(const QString& code);
    [[nodiscard]] QString theme() const; ///< "system", "light", "dark" or "contrast"
    void setTheme(const QString& theme);
    [[nodiscard]] int fontSize() const; ///< in per cent of the system's; 100: as it is
    void setFontSize(int percent);
    [[nodiscard]] bool stockOnDiameter() const; ///< as the inputs show and take it
    void setStockOnDiameter(bool onDiameter);
    [[nodiscard]] bool allInputs() const; ///< not the usual ones alone
    void setAllInputs(bool all);
    [[nodiscard]] bool tourSeen() const; ///< the tour of the window was shown once
    void setTourSeen();
    [[nodiscard]] QString handout() const; ///< what the last course hand-out had, in words
    void setHandout(const QString& words);
    [[nodiscard]] Company company() const; ///< of the heads of documents
    void setCompany(const Company& company);
    [[nodiscard]] QVariantMap titlePage() const; ///< of the reports of a course, by its keys
    void setTitlePage(const QVariantMap& texts);
    /// Name and group of the student who worked last.
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
    /// Keys of the columns that were hidden in a table, which is known by its object name.
    [[nodiscard]] QStringList hiddenColumns(const QString& table) const;
    void setHiddenColumns(const QString& table, const QStringList& keys);

    /// Where the file stands, and what else is the user's own; empty when nothing is kept.
    [[nodiscard]] const QString& folder() const { return m_folder; }
    std::optional<FileError> flush() { return m_file->flush(); } ///< writes now what is unwritten
    /// The file itself: what was put aside or could not be read, and what it refuses.
    [[nodiscard]] SettingsFile& file() const { return *m_file; }

    static constexpr int recentFilesKept = 9; ///< as many as there are digits to choose one by

private:
    [[nodiscard]] QString oneOf(const QString& key, const QStringList& allowed) const;

    std::unique_ptr<SettingsFile> m_file;
    QString m_folder;
};

} // namespace sparkout
