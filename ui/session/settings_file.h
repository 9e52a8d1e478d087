// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <QObject>
#include <QString>
#include <QTimer>
#include <QVariantMap>

#include <optional>

namespace sparkout {

/// Keys and values in a small JSON file, written by the one safe writer. A damaged file is put
/// aside as NAME.damaged and never stops anybody; one that cannot be written is not insisted on.
/// What could be neither read nor put aside is never written over.
class SettingsFile : public QObject {
    Q_OBJECT

public:
    /// An empty path: nothing is read or written.
    explicit SettingsFile(const QString& path);
    ~SettingsFile() override; ///< writes what is not written yet

    [[nodiscard]] QVariant value(const QString& key) const { return m_values.value(key); }
    void set(const QString& key, const QVariant& value);
    void refresh(); ///< takes what another instance has written meanwhile
    /// Writes now. What another instance wrote meanwhile is kept, but for the keys set here. A file
    /// that cannot be read now stays as it is; what was set is written another time.
    std::optional<FileError> flush();

    /// Where a damaged file was put aside; empty when it was in order.
    [[nodiscard]] const QString& damaged() const { return m_damaged; }
    /// Why a file that is there was not read: a pipe, a device, no right to read it; or why a
    /// damaged one was not put aside.
    [[nodiscard]] const std::optional<FileError>& unreadable() const { return m_unreadable; }

private:
    [[nodiscard]] std::optional<QVariantMap> read(); ///< nothing: it must stay as it is
    [[nodiscard]] bool putAside();

    QString m_path;
    QString m_damaged;
    std::optional<FileError> m_unreadable;
    QVariantMap m_values;
    QVariantMap m_changed; ///< set here and not written yet
    QTimer m_later;
};

} // namespace sparkout
