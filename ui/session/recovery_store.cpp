// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/recovery_store.h"

#include "core/project/project_file.h"
#include "core/project/temporary_file.h"
#include "ui/session/project_io.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QUuid>

#include <algorithm>

#include <fcntl.h>

namespace sparkout {

namespace {

const QString suffix = QStringLiteral(".recovery");
const QString lockSuffix = QStringLiteral(".lock");
const QString timeFormat = QStringLiteral("yyyyMMdd'T'HHmmss");

QString idOf(const QString& file) {
    return QFileInfo(file).completeBaseName();
}

/// When a file was discarded stands in its name: copying a folder changes the times.
QDateTime discardedWhen(const QString& file) {
    const QString name = QFileInfo(file).fileName();
    QDateTime when = QDateTime::fromString(name.section(u'-', 0, 0), timeFormat);
    when.setTimeSpec(Qt::UTC);
    return when;
}

void sortNewestFirst(std::vector<RecoveryItem>& items) {
    std::stable_sort(items.begin(), items.end(), [](const RecoveryItem& a, const RecoveryItem& b) {
        return a.header.when > b.header.when;
    });
}

} // namespace

RecoveryClaim::RecoveryClaim(QString file, std::unique_ptr<QLockFile> lock)
    : m_file(std::move(file)), m_lock(std::move(lock)) {}
RecoveryClaim::~RecoveryClaim() = default;

RecoveryStore::RecoveryStore(const QString& stateFolder)
    : m_folder(stateFolder + QStringLiteral("/recovery"))
    , m_discarded(m_folder + QStringLiteral("/discarded")) {}

RecoveryClaimPtr RecoveryStore::claimNew() const {
    return makePrivateFolder(m_folder) ? claim(QUuid::createUuid().toString(QUuid::Id128))
                                       : nullptr;
}

RecoveryClaimPtr RecoveryStore::claim(const QString& id) const {
    auto lock = std::make_unique<QLockFile>(m_folder + u'/' + id + lockSuffix);
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) {
        return nullptr;
    }
    return RecoveryClaimPtr(new RecoveryClaim(m_folder + u'/' + id + suffix, std::move(lock)));
}

std::vector<RecoveryItem> RecoveryStore::left() const {
    std::vector<RecoveryItem> items;
    const QDir folder(m_folder);
    for (const QString& name : folder.entryList({u'*' + suffix}, QDir::Files, QDir::Name)) {
        RecoveryClaimPtr claimed = claim(idOf(name));
        if (!claimed) {
            continue; // its session runs
        }
        RecoveryItem item = readItem(folder.filePath(name));
        if (item.state == RecoveryItem::State::ready && !item.header.modified) {
            (void)discard(item.file); // the edits had been undone: nothing is lost
            continue;
        }
        item.claim = std::move(claimed);
        items.push_back(std::move(item));
    }
    for (const QString& name : folder.entryList({u'*' + lockSuffix}, QDir::Files)) {
        tidy(idOf(name));
    }
    sortNewestFirst(items);
    return items;
}

/// What a session left that was killed before its first recovery file was whole.
void RecoveryStore::tidy(const QString& id) const {
    const QString file = m_folder + u'/' + id + suffix;
    if (QFileInfo::exists(file)) {
        return;
    }
    if (const RecoveryClaimPtr claimed = claim(id)) { // its end removes the lock
        const Descriptor folder =
            openAt(AT_FDCWD, QFile::encodeName(m_folder).toStdString(), O_RDONLY | O_DIRECTORY);
        if (folder) {
            removeLeftovers(folder.get(),
                            temporaryPrefix(QFile::encodeName(id + suffix).toStdString()));
        }
    }
}

RecoveryItem RecoveryStore::readItem(const QString& file) {
    RecoveryItem item;
    item.file = file;
    item.state = RecoveryItem::State::damaged;
    // The header comes on top of what a project may hold.
    const auto read = readFile(systemPath(file), limits::fileBytes + (64u << 10));
    if (const auto* text = std::get_if<std::string>(&read)) {
        RecoveryContent content = readRecovery(*text);
        item.header = std::move(content.header);
        if (content.project) {
            item.state = RecoveryItem::State::ready;
        }
    }
    if (!item.header.when.isValid()) {
        item.header.when = QFileInfo(file).lastModified();
    }
    return item;
}

std::vector<RecoveryItem> RecoveryStore::discarded() const {
    std::vector<RecoveryItem> items;
    const QDir folder(m_discarded);
    for (const QString& name : folder.entryList({u'*' + suffix}, QDir::Files)) {
        RecoveryItem item = readItem(folder.filePath(name));
        if (item.state == RecoveryItem::State::ready) {
            item.state = RecoveryItem::State::discarded;
        }
        items.push_back(std::move(item));
    }
    sortNewestFirst(items);
    return items;
}

bool RecoveryStore::discard(const QString& file) const {
    if (!QFileInfo::exists(file) || !makePrivateFolder(m_discarded)) {
        return false;
    }
    // A number of its own: the same session may discard twice a second.
    const QString name = QDateTime::currentDateTimeUtc().toString(timeFormat) + u'-'
                         + QUuid::createUuid().toString(QUuid::Id128) + suffix;
    return QFile::rename(file, m_discarded + u'/' + name);
}

void RecoveryStore::removeOldDiscarded(const QDateTime& now) const {
    const QDir folder(m_discarded);
    for (const QString& name : folder.entryList({u'*' + suffix}, QDir::Files)) {
        const QDateTime when = discardedWhen(name);
        if (when.isValid() && when.daysTo(now.toUTC()) > discardedDays) {
            QFile::remove(folder.filePath(name));
        }
    }
}

QString userStateFolder() {
    QString folder = qEnvironmentVariable("XDG_STATE_HOME");
    if (!QDir::isAbsolutePath(folder)) {
        folder = QDir::homePath() + QStringLiteral("/.local/state");
    }
    return folder + QStringLiteral("/sparkout");
}

bool makePrivateFolder(const QString& path) {
    const QDir folder(path);
    if (folder.exists()) {
        return true;
    }
    const QString parent = QFileInfo(path).absolutePath();
    constexpr auto own = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
    return (QFileInfo(parent).isDir() || makePrivateFolder(parent))
           && QDir(parent).mkdir(QFileInfo(path).fileName(), own);
}

} // namespace sparkout
