// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/backup_history.h"

#include "ui/files/disk_state.h"
#include "ui/files/recovery_store.h"
#include "ui/session/project_io.h"
#include "ui/text/system_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

const QString timeFormat = QStringLiteral("yyyyMMdd'T'HHmmss'Z'");
constexpr qsizetype longestName = 60;

bool sameBytes(const EarlierVersion& version, std::string_view bytes) {
    return version.bytes == qint64(bytes.size())
           && diskState(version.file).hash == contentHash(bytes);
}

} // namespace

BackupHistory::BackupHistory(const QString& stateFolder, BackupCaps caps)
    : m_folder(stateFolder + QStringLiteral("/backups")), m_caps(caps) {}

/// The name is for people, the hash distinguishes files of the same name.
QString BackupHistory::folderOf(const QString& path) const {
    const QString real = realPath(path);
    const QByteArray hash = contentHash(systemText(real)).toHex().left(16);
    return m_folder + u'/' + QFileInfo(real).completeBaseName().left(longestName) + u'-'
           + QString::fromLatin1(hash);
}

std::vector<EarlierVersion> BackupHistory::versions(const QString& path) const {
    std::vector<EarlierVersion> list;
    const QDir folder(folderOf(path));
    for (const QFileInfo& file : folder.entryInfoList(QDir::Files)) {
        QDateTime when = QDateTime::fromString(file.completeBaseName(), timeFormat);
        when.setTimeSpec(Qt::UTC);
        if (when.isValid()) {
            list.push_back({file.filePath(), when, file.size()});
        }
    }
    std::sort(list.begin(), list.end(),
              [](const EarlierVersion& a, const EarlierVersion& b) { return a.when > b.when; });
    return list;
}

std::optional<FileError> BackupHistory::keep(const QString& path, std::string_view bytes,
                                             const QDateTime& now, Whose whose) const {
    std::vector<EarlierVersion> list = versions(path);
    const bool isSoon =
        !list.empty() && std::abs(list.front().when.secsTo(now)) < m_caps.apart.count();
    if ((isSoon && whose == Whose::own) || (!list.empty() && sameBytes(list.front(), bytes))) {
        return {};
    }
    QDateTime when = now.toUTC();
    while (std::ranges::any_of(
        list, [&](const EarlierVersion& version) { return version.when.secsTo(when) == 0; })) {
        when = when.addSecs(1); // names have a resolution of a second
    }
    const QString folder = folderOf(path);
    const QString suffix = QFileInfo(path).suffix();
    const QString file =
        folder + u'/' + when.toString(timeFormat) + (suffix.isEmpty() ? suffix : u'.' + suffix);
    FileError noFolder;
    noFolder.path = systemText(folder);
    noFolder.step = FileStep::create;
    if (!makePrivateFolder(folder)) {
        return noFolder;
    }
    if (auto error = writeFileSafely(systemPath(file), bytes)) {
        return error;
    }
    list.insert(list.begin(), {file, when, qint64(bytes.size())});
    drop(std::move(list), now);
    return {};
}

void BackupHistory::drop(std::vector<EarlierVersion> versions, const QDateTime& now) const {
    const auto remove = [&versions](std::size_t index) {
        QFile::remove(versions[index].file);
        versions.erase(versions.begin() + std::ptrdiff_t(index));
    };
    const QDate today = now.toLocalTime().date();
    const auto ofToday = [&] {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < versions.size(); ++i) {
            if (versions[i].when.toLocalTime().date() == today) {
                found.push_back(i);
            }
        }
        return found;
    };
    for (auto found = ofToday(); found.size() > std::size_t(std::max(m_caps.filesADay, 1));
         found = ofToday()) {
        const bool aMiddleOne = found.size() > 2; // newest first: the day's first is last
        remove(found[found.size() - (aMiddleOne ? 2 : 1)]);
    }
    const auto size = [&versions] {
        return std::accumulate(
            versions.begin(), versions.end(), qint64{0},
            [](qint64 sum, const EarlierVersion& version) { return sum + version.bytes; });
    };
    while (versions.size() > 1
           && (std::cmp_greater(versions.size(), m_caps.files) || size() > m_caps.bytes)) {
        remove(versions.size() - 1);
    }
}

std::vector<EarlierVersion> earlierVersions(const BackupHistory& history, const QString& path) {
    std::vector<EarlierVersion> list = history.versions(path);
    if (const QFileInfo last(realPath(path) + QStringLiteral(".bak")); last.isFile()) {
        list.push_back({last.filePath(), last.metadataChangeTime().toUTC(), last.size()});
    }
    std::sort(list.begin(), list.end(),
              [](const EarlierVersion& a, const EarlierVersion& b) { return a.when > b.when; });
    return list;
}

} // namespace sparkout
