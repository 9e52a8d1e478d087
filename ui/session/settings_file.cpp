// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/settings_file.h"

#include "core/files/file_system.h"
#include "ui/session/project_io.h"
#include "ui/text/system_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <cerrno>

namespace sparkout {

namespace {

constexpr std::size_t largest = 1u << 20;
constexpr int later_ms = 500; ///< several settings are often set together

} // namespace

SettingsFile::SettingsFile(const QString& path) : m_path(path) {
    m_later.setSingleShot(true);
    m_later.setInterval(later_ms);
    connect(&m_later, &QTimer::timeout, this, [this] { (void)flush(); });
    if (!m_path.isEmpty()) {
        m_values = read().value_or(QVariantMap());
    }
}

SettingsFile::~SettingsFile() {
    (void)flush();
}

std::optional<QVariantMap> SettingsFile::read() {
    const auto bytes = readFile(systemPath(m_path), largest);
    const auto* text = std::get_if<std::string>(&bytes);
    const auto* error = std::get_if<FileError>(&bytes);
    m_unreadable.reset();
    const auto damaged = [this] {
        return putAside() ? std::optional<QVariantMap>(QVariantMap()) : std::nullopt;
    };
    if (error != nullptr) {
        if (error->step == FileStep::tooLarge) {
            return damaged();
        }
        if (error->systemError == ENOENT || error->systemError == ENOTDIR) {
            return QVariantMap(); // the defaults hold
        }
        m_unreadable = *error;
        return std::nullopt;
    }
    QJsonParseError fault;
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray::fromStdString(*text), &fault);
    if (fault.error != QJsonParseError::NoError || !document.isObject()) {
        return damaged();
    }
    return document.object().toVariantMap();
}

bool SettingsFile::putAside() {
    const QString aside = m_path + QStringLiteral(".damaged");
    // Not QFile::rename(): what it cannot rename it opens and copies.
    const int failed = renamePath(systemPath(m_path), systemPath(aside));
    if (failed == 0) {
        m_damaged = aside;
        return true;
    }
    m_unreadable = FileError{systemText(m_path), FileStep::backup, failed, {}};
    return false;
}

void SettingsFile::set(const QString& key, const QVariant& value) {
    if (m_values.value(key) == value) {
        return;
    }
    m_values.insert(key, value);
    m_changed.insert(key, value);
    if (!m_path.isEmpty() && QCoreApplication::instance() != nullptr) {
        m_later.start();
    }
}

void SettingsFile::refresh() {
    if (m_path.isEmpty()) {
        return;
    }
    if (std::optional<QVariantMap> values = read()) { // else those that were read before hold
        m_values = *std::move(values);
        m_values.insert(m_changed);
    }
}

std::optional<FileError> SettingsFile::flush() {
    m_later.stop();
    if (m_path.isEmpty() || m_changed.isEmpty()) {
        return {};
    }
    QDir().mkpath(QFileInfo(m_path).absolutePath()); // its failure is the writer's
    std::optional<QVariantMap> values = read();
    if (!values) {
        return m_unreadable;
    }
    values->insert(m_changed);
    const QByteArray text = QJsonDocument(QJsonObject::fromVariantMap(*values)).toJson();
    auto error = writeFileSafely(systemPath(m_path), {text.constData(), std::size_t(text.size())});
    if (!error) {
        m_changed.clear();
    }
    return error;
}

} // namespace sparkout
