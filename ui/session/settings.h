// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/file/safe_file.h"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QVariantMap>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace sparkout {

struct CardEntries;

/// Company data in the heads of documents, in addition to the project. All of it may be empty.
struct CompanyTexts {
    std::string name;
    std::string department;
    std::string developed; ///< names of the signatories
    std::string checked;
    std::string agreed;
    std::string standards; ///< name of the standards checker
    std::string approved;
    std::string designation;                  ///< designation of the document
    std::string part;                         ///< designation of the part
    std::string shop, area, place, operation; ///< numbers of shop, area, workplace and operation

    friend bool operator==(const CompanyTexts&, const CompanyTexts&) = default;
};

/// The texts and the logo of a company.
struct Company : CompanyTexts {
    QByteArray logo; ///< contents of a file that satisfies Logo

    friend bool operator==(const Company&, const Company&) = default;

    /// Returns the company with the numbers that a project gives in place of its own.
    [[nodiscard]] Company with(const CardEntries& entries) const;
    /// Returns the form in which settings store it; empty texts are left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Company fromKept(const QVariantMap& kept);
};

template <>
const StructInfo& tableOf<CompanyTexts>();

namespace limits {
/// Greatest size of the file: sufficient for the largest logo and all texts that the window's
/// inputs accept.
inline constexpr std::size_t settingsBytes = 4u << 20;
} // namespace limits

/// Keys and values in a small JSON file, written by the safe writer. A damaged file is put aside
/// (putAside()) and never prevents a start; a file that cannot be written is not retried. A file
/// that could be neither read nor put aside is never overwritten, and contents that this reader
/// would refuse are never written.
class SettingsFile : public QObject {
    Q_OBJECT

public:
    /// With an empty path nothing is read or written.
    explicit SettingsFile(const QString& path);
    ~SettingsFile() override; ///< writes unsaved changes

    [[nodiscard]] QVariant value(const QString& key) const { return m_values.value(key); }
    /// Sets a value; one with which the file would be too large is rejected with refused().
    void set(const QString& key, const QVariant& value);
    void refresh(); ///< reads the changes that another instance has written
    /// Writes the changes now. Values written by another instance are kept, except for the keys set
    /// here. A file that cannot be read stays as it is; the changes are then written later.
    std::optional<FileError> flush();

    /// Returns the paths of damaged files that any instance put aside and takeDamaged() has not
    /// returned yet.
    [[nodiscard]] QStringList damaged() const;
    QStringList takeDamaged(); ///< returns each of them once
    /// Returns the reason why an existing file was not read (a pipe, a device, no permission) or a
    /// damaged one not put aside.
    [[nodiscard]] const std::optional<FileError>& unreadable() const { return m_unreadable; }

signals:
    void refused(sparkout::FileError error); ///< the file would be too large to be read again
    void foundDamaged();                     ///< a file was put aside

private:
    /// Contents of the file, and its sha256().
    struct Content {
        QVariantMap values;
        std::string sha256;
    };
    [[nodiscard]] std::optional<Content> read();
    [[nodiscard]] bool mayBeRead(const QByteArray& text);

    QString m_path;
    std::optional<FileError> m_unreadable;
    QVariantMap m_values;
    QVariantMap m_changed; ///< values set here and not written yet
    QTimer m_later;
};

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
