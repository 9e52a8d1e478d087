// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QVariantMap>

#include <cstddef>
#include <optional>

namespace sparkout {

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

} // namespace sparkout
