// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/settings_file.h"

#include "core/sha256.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <cerrno>
#include <utility>

namespace sparkout {

namespace {

constexpr int later_ms = 500; ///< several settings are often set together
const QString reportedKey = QStringLiteral("damagedReported");

QByteArray textOf(const QVariantMap& values) {
    return QJsonDocument(QJsonObject::fromVariantMap(values)).toJson();
}

} // namespace

SettingsFile::SettingsFile(const QString& path) : m_path(path) {
    m_later.setSingleShot(true);
    m_later.setInterval(later_ms);
    connect(&m_later, &QTimer::timeout, this, [this] { (void)flush(); });
    refresh();
}

SettingsFile::~SettingsFile() {
    (void)flush();
}

std::optional<SettingsFile::Content> SettingsFile::read() {
    m_unreadable.reset();
    const auto bytes = readFile(systemPath(m_path), limits::settingsBytes);
    const auto* text = std::get_if<std::string>(&bytes);
    const auto* error = std::get_if<FileError>(&bytes);
    if (error != nullptr && error->step != FileStep::tooLarge) {
        if (error->systemError == ENOENT || error->systemError == ENOTDIR) {
            return Content{}; // defaults apply
        }
        m_unreadable = *error;
        return std::nullopt;
    }
    if (text != nullptr) {
        QJsonParseError fault;
        const QJsonDocument document =
            QJsonDocument::fromJson(QByteArray::fromStdString(*text), &fault);
        if (fault.error == QJsonParseError::NoError && document.isObject()) {
            return Content{document.object().toVariantMap(), sha256(*text)};
        }
    }
    // Another instance may have written a valid one since.
    const auto again = readFile(systemPath(m_path), limits::settingsBytes);
    if (const auto* now = std::get_if<std::string>(&again);
        now != nullptr && (text == nullptr || *now != *text)) {
        return read();
    }
    const auto aside = putAside(systemPath(m_path));
    if (const auto* failed = std::get_if<FileError>(&aside)) {
        m_unreadable = *failed;
        return std::nullopt;
    }
    emit foundDamaged();
    return Content{m_values, {}}; // keeps the values read before
}

QStringList SettingsFile::damaged() const {
    if (m_path.isEmpty()) {
        return {};
    }
    const QFileInfo file(m_path);
    const QStringList reported = m_values.value(reportedKey).toStringList();
    QStringList found;
    for (const QFileInfo& aside : file.dir().entryInfoList(
             {file.fileName() + QStringLiteral(".damaged*")}, QDir::Files, QDir::Name)) {
        if (!reported.contains(aside.fileName())) {
            found += aside.filePath();
        }
    }
    return found;
}

QStringList SettingsFile::takeDamaged() {
    const QStringList found = damaged();
    QStringList reported = m_values.value(reportedKey).toStringList();
    const QDir folder = QFileInfo(m_path).dir();
    reported.removeIf([&folder](const QString& name) { return !folder.exists(name); });
    for (const QString& path : found) {
        reported += QFileInfo(path).fileName();
    }
    if (reported != m_values.value(reportedKey).toStringList()) {
        set(reportedKey, reported);
    }
    return found;
}

bool SettingsFile::mayBeRead(const QByteArray& text) {
    const bool may = std::size_t(text.size()) <= limits::settingsBytes;
    if (!may) {
        emit refused({systemText(m_path), FileStep::content, 0, {}});
    }
    return may;
}

void SettingsFile::set(const QString& key, const QVariant& value) {
    if (m_values.value(key) == value) {
        return;
    }
    QVariantMap values = m_values;
    values.insert(key, value);
    if (!m_path.isEmpty() && !mayBeRead(textOf(values))) {
        return;
    }
    m_values = std::move(values);
    m_changed.insert(key, value);
    if (!m_path.isEmpty() && QCoreApplication::instance() != nullptr) {
        m_later.start();
    }
}

void SettingsFile::refresh() {
    if (m_path.isEmpty()) {
        return;
    }
    if (std::optional<Content> content = read()) { // otherwise the values read before are kept
        m_values = std::move(content->values);
        m_values.insert(m_changed);
    }
}

std::optional<FileError> SettingsFile::flush() {
    m_later.stop();
    if (m_path.isEmpty() || m_changed.isEmpty()) {
        return {};
    }
    QDir().mkpath(QFileInfo(m_path).absolutePath()); // a failure shows when writing
    std::optional<FileError> error;
    for (int attempt = 0; attempt < mergeAttempts; ++attempt) {
        std::optional<Content> content = read();
        if (!content) {
            return m_unreadable;
        }
        content->values.insert(m_changed);
        const QByteArray text = textOf(content->values);
        if (!mayBeRead(text)) {
            return FileError{systemText(m_path), FileStep::content, 0, {}};
        }
        error = writeFileSafely(systemPath(m_path), {text.constData(), std::size_t(text.size())},
                                {.keepBackup = true, .expected = content->sha256});
        if (!error) {
            m_changed.clear();
            return {};
        }
        if (error->step != FileStep::changed) {
            break;
        }
    }
    return error;
}

} // namespace sparkout
