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
/// Of the whole file: room for the largest logo and for all texts that the window's inputs take.
inline constexpr std::size_t settingsBytes = 4u << 20;
} // namespace limits

/// Keys and values in a small JSON file, written by the one safe writer. A damaged file is put
/// aside (putAside()) and never stops anybody; one that cannot be written is not insisted on. What
/// could be neither read nor put aside is never written over, and what this reader would refuse is
/// never written.
class SettingsFile : public QObject {
    Q_OBJECT

public:
    /// An empty path: nothing is read or written.
    explicit SettingsFile(const QString& path);
    ~SettingsFile() override; ///< writes what is not written yet

    [[nodiscard]] QVariant value(const QString& key) const { return m_values.value(key); }
    /// A value with which the file would be too large is not taken: refused() says so.
    void set(const QString& key, const QVariant& value);
    void refresh(); ///< takes what another instance has written meanwhile
    /// Writes now. What another instance wrote meanwhile is kept, but for the keys set here. A file
    /// that cannot be read now stays as it is; what was set is written another time.
    std::optional<FileError> flush();

    /// Where damaged files were put aside, by any instance, and takeDamaged() has not given yet.
    [[nodiscard]] QStringList damaged() const;
    QStringList takeDamaged(); ///< the same, each of them once
    /// Why a file that is there was not read: a pipe, a device, no right to read it; or why a
    /// damaged one was not put aside.
    [[nodiscard]] const std::optional<FileError>& unreadable() const { return m_unreadable; }

signals:
    void refused(sparkout::FileError error); ///< it would be too large to be read again
    void foundDamaged();                     ///< a file was put aside

private:
    /// What stands in the file, and its sha256(); nothing: it must stay as it is.
    struct Content {
        QVariantMap values;
        std::string sha256;
    };
    [[nodiscard]] std::optional<Content> read();
    [[nodiscard]] bool mayBeRead(const QByteArray& text);

    QString m_path;
    std::optional<FileError> m_unreadable;
    QVariantMap m_values;
    QVariantMap m_changed; ///< set here and not written yet
    QTimer m_later;
};

} // namespace sparkout
