// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/guarded_file.h"

#include "core/file/project_file.h"
#include "ui/session/recovery_store.h"
#include "ui/text/file_error_text.h"

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

namespace {

/// A program that saves touches its file several times.
constexpr int settle_ms = 200;

} // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(settle_ms);
    connect(&m_settle, &QTimer::timeout, this, &FileWatch::look);
    const auto settle = [this] { m_settle.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, settle);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, settle);
}

void FileWatch::follow(const QString& path, const QByteArray& hash) {
    pause();
    m_path = path;
    m_known = hash;
    m_told.clear();
    m_toldMissing = false;
    m_stamp.reset(); // reads at the first check: the file may have changed since it was loaded
    if (!m_path.isEmpty()) {
        watchPaths();
        m_settle.start();
    }
}

void FileWatch::pause() {
    ++m_round;
    m_settle.stop();
    const QStringList paths = m_watcher.files() + m_watcher.directories();
    if (!paths.isEmpty()) {
        m_watcher.removePaths(paths);
    }
    m_path.clear();
}

void FileWatch::check() {
    if (!m_path.isEmpty() && !m_settle.isActive()) {
        look();
    }
}

/// A replaced file drops out of the watcher; its folder does not.
void FileWatch::watchPaths() {
    const QString real = realPath(m_path);
    for (const QString& path : {real, QFileInfo(real).absolutePath()}) {
        if (QFileInfo::exists(path) && !m_watcher.files().contains(path)
            && !m_watcher.directories().contains(path)) {
            m_watcher.addPath(path);
        }
    }
}

void FileWatch::look() {
    if (m_path.isEmpty()) {
        return;
    }
    watchPaths();
    m_background.start([this, path = m_path, before = m_stamp, round = m_round] {
        const auto stamp = stampOf(path);
        const bool same = stamp && before && *stamp == *before;
        const DiskState state = same ? DiskState{} : diskState(path);
        return Background::Answer([this, same, state, stamp, round] {
            if (!same && round == m_round) {
                judge(state, stamp);
            }
        });
    });
}

void FileWatch::judge(const DiskState& state, const std::optional<FileStamp>& stamp) {
    m_stamp = stamp;
    const bool missing = state.kind != DiskState::Kind::file;
    if (missing ? m_toldMissing : state.hash == m_told) {
        return;
    }
    const bool known = !missing && state.hash == m_known;
    const bool told = m_toldMissing || !m_told.isEmpty();
    m_toldMissing = missing;
    m_told = known ? QByteArray() : state.hash;
    if (!known) {
        emit changed(state);
    } else if (told) {
        emit restored();
    }
}

GuardedFile::GuardedFile(QObject* parent) : QObject(parent) {
    connect(&m_watch, &FileWatch::changed, this, &GuardedFile::changedOnDisk);
    connect(&m_watch, &FileWatch::restored, this, &GuardedFile::restoredOnDisk);
}

void GuardedFile::protect(const QString& stateFolder) {
    m_isProtected = true;
    m_history = stateFolder.isEmpty() ? std::nullopt : std::optional(BackupHistory(stateFolder));
}

void GuardedFile::unprotect() {
    m_isProtected = false;
    m_history.reset();
}

bool GuardedFile::isFile(const QString& path) const {
    return !m_path.isEmpty() && realPath(path) == realPath(m_path);
}

GuardedFile::Access GuardedFile::claim(const QString& path) {
    dropClaim();
    m_claimed = realPath(path);
    m_keepLock = isFile(path) && m_lock.stillOurs();
    if (!mayBeWritten(path)) {
        return Access::readOnly;
    }
    if (m_keepLock || !m_isProtected) {
        return Access::write;
    }
    switch (m_claim.acquire(path)) {
    case FileLock::State::conflict: return Access::conflict;
    case FileLock::State::noRight: return Access::readOnly;
    default: return Access::write; // a missing lock must not prevent work
    }
}

GuardedFile::Access GuardedFile::takeOver() {
    return m_claim.takeOver() == FileLock::State::conflict ? Access::conflict : Access::write;
}

void GuardedFile::dropClaim() {
    m_claim.release();
    m_claimed.clear();
    m_keepLock = false;
}

/// The contents are now those of the claimed file.
void GuardedFile::settleClaim() {
    if (m_claim.state() == FileLock::State::conflict) {
        m_claim.release();
    }
    if (!m_keepLock) {
        m_lock = std::move(m_claim);
    }
    dropClaim();
}

void GuardedFile::follow(const QString& path, const QByteArray& hash, bool readOnly) {
    const bool isSame = isFile(path);
    m_path = path;
    m_hash = hash;
    m_isReadOnly = readOnly;
    if (!m_claimed.isEmpty() && isFile(m_claimed)) {
        settleClaim();
    } else if (!isSame) {
        m_lock.release();
    }
    followDisk();
}

void GuardedFile::followDisk() {
    m_attempted.clear();
    m_seen.reset();
    if (m_isProtected) {
        m_watch.follow(m_path, m_hash);
    }
}

bool GuardedFile::isKnown(const QByteArray& hash) const {
    return hash == m_hash || (!hash.isEmpty() && hash == m_attempted);
}

std::optional<DiskState> GuardedFile::changedOutside(const QString& path) {
    m_seen.reset();
    if (!isFile(path)) {
        return {};
    }
    DiskState state;
    runAside([&] { state = diskState(path); });
    if (state.kind == DiskState::Kind::unreadable) {
        return {}; // it cannot be checked; the save reports the error
    }
    m_seen = state;
    return isKnown(state.hash) ? std::nullopt : m_seen;
}

/// The version that a write may replace; empty: any, since the user has chosen the file.
std::optional<std::string> GuardedFile::expectedAt(const QString& path) const {
    if (!isFile(path)) {
        return std::nullopt;
    }
    const QByteArray& hash = m_seen ? m_seen->hash : m_attempted.isEmpty() ? m_hash : m_attempted;
    return hash.toHex().toStdString();
}

/// Keeps the version about to be replaced. A failure does not prevent saving: the version also
/// becomes NAME.bak, without which a save is refused.
void GuardedFile::keepEarlierVersion(const BackupHistory& history, const QString& path,
                                     const std::function<bool(const QByteArray& hash)>& isOwn) {
    const auto old = readFile(systemPath(path), limits::fileBytes);
    if (const auto* bytes = std::get_if<std::string>(&old)) {
        using Whose = BackupHistory::Whose;
        (void)history.keep(path, *bytes, QDateTime::currentDateTimeUtc(),
                           isOwn(contentHash(*bytes)) ? Whose::own : Whose::foreign);
    }
}

std::optional<FileError> GuardedFile::write(const QString& path, const MakeContent& make) {
    m_watch.pause();
    SavedContent saved;
    runAside([&, expected = expectedAt(path)] {
        if (m_history) {
            keepEarlierVersion(*m_history, path, [&](const QByteArray& hash) {
                return isFile(path) && isKnown(hash);
            });
        }
        saved = saveContent(make, path, {.keepBackup = true, .expected = expected});
    });
    if (saved.error) {
        followDisk();
        m_attempted = saved.error->replaced ? saved.hash : QByteArray();
        return saved.error;
    }
    follow(path, saved.hash);
    return {};
}

std::optional<FileError> GuardedFile::amend(const QString& path, Waiting waiting,
                                            const std::function<std::optional<Amendment>()>& read) {
    constexpr int attempts = 100; // another program may change the file each time
    SavedContent saved;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const std::optional<Amendment> amended = read();
        if (!amended) {
            return {};
        }
        const auto write = [&] {
            const QString folder = QFileInfo(path).absolutePath();
            QDir().mkpath(folder); // a failure shows when writing
            keepEarlierVersion(BackupHistory(folder), path, [](const QByteArray&) { return true; });
            saved = saveContent([&] { return amended->text; }, path,
                                {.keepBackup = true, .expected = amended->expected});
        };
        if (waiting == Waiting::aside) {
            runAside(write);
        } else {
            write();
        }
        if (!saved.error || saved.error->step != FileStep::changed) {
            break;
        }
    }
    return saved.error;
}

} // namespace sparkout
