// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/recovery_store.h"

#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/setup/setup_file.h"
#include "ui/session/file_lock.h"
#include "ui/session/project_io.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace sparkout {

namespace {

const QString recoverySuffix = QStringLiteral(".recovery");
const QString lockSuffix = QStringLiteral(".lock");
const QString recoveryTimeFormat = QStringLiteral("yyyyMMdd'T'HHmmss");

/// Whether a lock surely belongs to a program that no longer runs. QLockFile knows more, but only
/// by taking the lock, which waits for the disk.
bool surelyDead(const QString& lock) {
    qint64 process = 0;
    QString host, program;
    return QLockFile(lock).getLockInfo(&process, &host, &program) && isThisComputer(host)
           && !isRunning(process);
}

/// The recovery files of a folder, including pipes and the like, which are listed but not read.
QStringList recoveryNames(const QDir& folder) {
    return folder.entryList({u'*' + recoverySuffix}, QDir::Files | QDir::System, QDir::Name);
}

QString idOf(const QString& file) {
    return QFileInfo(file).completeBaseName();
}

/// The time of discarding, from the file's name, since copying a folder changes file times.
QDateTime discardedWhen(const QString& file) {
    const QString name = QFileInfo(file).fileName();
    QDateTime when = QDateTime::fromString(name.section(u'-', 0, 0), recoveryTimeFormat);
    when.setTimeSpec(Qt::UTC);
    return when;
}

void sortNewestFirst(std::vector<RecoveryItem>& items) {
    std::stable_sort(items.begin(), items.end(), [](const RecoveryItem& a, const RecoveryItem& b) {
        return a.header.when > b.header.when;
    });
}

const QString formatKey = QStringLiteral("format");
const QString format = QStringLiteral("sparkout-recovery");
const QString hashKey = QStringLiteral("sha256");
const QString titleKey = QStringLiteral("title");
const QString pathKey = QStringLiteral("path");
const QString whenKey = QStringLiteral("when");
const QString diskHashKey = QStringLiteral("disk_sha256");
const QString readOnlyKey = QStringLiteral("read_only");
const QString modifiedKey = QStringLiteral("modified");
const QString openKey = QStringLiteral("open");
constexpr std::size_t longestHeader = 64u << 10;

QByteArray hexOf(const QJsonObject& object, const QString& key) {
    return QByteArray::fromHex(object.value(key).toString().toLatin1());
}

QByteArray hashOf(std::string_view text, const std::vector<std::string>& open) {
    if (open.empty()) {
        return contentHash(text);
    }
    std::string all(text);
    for (const std::string& path : open) {
        all += path + '\n';
    }
    return contentHash(all);
}

/// The line before the project's text; empty if there is none.
std::string_view headOf(std::string_view text) {
    const std::size_t end = text.find('\n');
    return end == std::string_view::npos || end > longestHeader ? std::string_view()
                                                                : text.substr(0, end);
}

} // namespace

class RecoveryOffer {
public:
    explicit RecoveryOffer(Descriptor lock) : m_lock(std::move(lock)) {}

private:
    Descriptor m_lock; ///< lock of the folder
};

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

QString RecoveryStore::lockOf(const QString& id) const {
    return m_folder + u'/' + id + lockSuffix;
}

RecoveryClaimPtr RecoveryStore::claim(const QString& id) const {
    if (!strangeLock(lockOf(id)).isEmpty()) {
        return nullptr;
    }
    auto lock = std::make_unique<QLockFile>(lockOf(id));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) {
        return nullptr;
    }
    return RecoveryClaimPtr(
        new RecoveryClaim(m_folder + u'/' + id + recoverySuffix, std::move(lock)));
}

RecoveryClaimPtr RecoveryStore::claim(const RecoveryItem& item) const {
    return item.offer ? claim(idOf(item.file)) : nullptr;
}

bool RecoveryStore::inUse(const RecoveryItem& item) const {
    return item.offer && inUse(idOf(item.file));
}

/// An object that is not a lock is ignored: nobody holds it.
bool RecoveryStore::inUse(const QString& id) const {
    const QString lock = lockOf(id);
    const bool free = !QFileInfo::exists(lock) || !strangeLock(lock).isEmpty() || surelyDead(lock);
    return !free && !claim(id);
}

std::vector<RecoveryItem> RecoveryStore::left(bool* offeredElsewhere) const {
    std::vector<RecoveryItem> items;
    Descriptor lock;
    const bool elsewhere = lockFolder(systemPath(m_folder), lock) == Locking::heldElsewhere;
    if (offeredElsewhere) {
        *offeredElsewhere = elsewhere;
    }
    if (elsewhere) {
        return items;
    }
    const auto offer = std::make_shared<const RecoveryOffer>(std::move(lock));
    const QDir folder(m_folder);
    for (const QString& name : recoveryNames(folder)) {
        if (inUse(idOf(name))) {
            continue; // its session is running
        }
        RecoveryItem item = readItem(folder.filePath(name));
        if (item.state == RecoveryItem::State::ready && !item.header.modified) {
            (void)discard(item.file); // the edits had been undone: nothing is lost
            continue;
        }
        item.offer = offer;
        items.push_back(std::move(item));
    }
    for (const QString& name : folder.entryList({u'*' + lockSuffix}, QDir::Files)) {
        tidy(idOf(name));
    }
    sortNewestFirst(items);
    return items;
}

/// Removes the remains of a session that was killed before its first recovery file was complete.
void RecoveryStore::tidy(const QString& id) const {
    const QString lock = lockOf(id);
    if (QFileInfo::exists(m_folder + u'/' + id + recoverySuffix) || !strangeLock(lock).isEmpty()) {
        return;
    }
    const RecoveryClaimPtr claimed = surelyDead(lock) ? nullptr : claim(id); // removed at its end
    if (!claimed && !(surelyDead(lock) && QFile::remove(lock))) {
        return;
    }
    Folder folder;
    if (openFolder(systemPath(m_folder), folder) == 0) {
        removeLeftovers(folder, temporaryPrefix((id + recoverySuffix).toStdString()));
    }
}

RecoveryItem RecoveryStore::readItem(const QString& file) {
    RecoveryItem item;
    item.file = file;
    item.state = RecoveryItem::State::damaged;
    // The header adds to the greatest size of a project.
    const auto read = readFile(systemPath(file), limits::fileBytes + (64u << 10));
    if (const auto* text = std::get_if<std::string>(&read)) {
        RecoveryGlance glance = glanceAtRecovery(*text); // the project is read when chosen
        item.header = std::move(glance.header);
        if (glance.whole) {
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
    for (const QString& name : recoveryNames(folder)) {
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
    const QFileInfo found(file);
    if ((!found.exists() && !found.isSymLink()) || !makePrivateFolder(m_discarded)) {
        return false;
    }
    // A unique number: a session may discard twice a second.
    const QString name = QDateTime::currentDateTimeUtc().toString(recoveryTimeFormat) + u'-'
                         + QUuid::createUuid().toString(QUuid::Id128) + recoverySuffix;
    // Not QFile::rename(), which copies if renaming fails.
    return renamePath(systemPath(file), systemPath(m_discarded + u'/' + name)) == 0;
}

void RecoveryStore::removeOldDiscarded(const QDateTime& now) const {
    const QDir folder(m_discarded);
    for (const QString& name : recoveryNames(folder)) {
        const QDateTime when = discardedWhen(name);
        if (when.isValid() && when.daysTo(now.toUTC()) > discardedDays) {
            QFile::remove(folder.filePath(name));
        }
    }
}

QString userStateFolder() {
#ifdef Q_OS_WIN
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)
           + QStringLiteral("/sparkout/state");
#else
    QString folder = qEnvironmentVariable("XDG_STATE_HOME");
    if (!QDir::isAbsolutePath(folder)) {
        folder = QDir::homePath() + QStringLiteral("/.local/state");
    }
    return folder + QStringLiteral("/sparkout");
#endif
}

bool makePrivateFolder(const QString& path) {
    const QDir folder(path);
    if (folder.exists()) {
        return true;
    }
    const QString parent = QFileInfo(path).absolutePath();
    constexpr auto own = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
    return (QFileInfo(parent).isDir() || makePrivateFolder(parent))
           && (QDir(parent).mkdir(QFileInfo(path).fileName(), own)
               || QFileInfo(path).isDir()); // another instance was quicker
}

std::string recoveryText(const RecoveryHeader& header, const Setup& setup) {
    const std::string text = writeSetup(setup);
    QJsonArray open;
    for (const std::string& path : header.open) {
        open.append(QString::fromStdString(path));
    }
    const QJsonObject object{
        {formatKey, format},
        {hashKey, QString::fromLatin1(hashOf(text, header.open).toHex())},
        {titleKey, header.title},
        {pathKey, header.path},
        {whenKey, header.when.toUTC().toString(Qt::ISODateWithMs)},
        {diskHashKey, QString::fromLatin1(header.diskHash.toHex())},
        {readOnlyKey, header.readOnly},
        {modifiedKey, header.modified},
        {openKey, open},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString() + '\n' + text;
}

RecoveryGlance glanceAtRecovery(std::string_view text) {
    RecoveryGlance glance;
    const std::string_view head = headOf(text);
    const QJsonObject object =
        QJsonDocument::fromJson(QByteArray(head.data(), qsizetype(head.size()))).object();
    if (object.value(formatKey).toString() != format) {
        return glance;
    }
    glance.header = {
        object.value(titleKey).toString(),
        object.value(pathKey).toString(),
        QDateTime::fromString(object.value(whenKey).toString(), Qt::ISODateWithMs),
        hexOf(object, diskHashKey),
        object.value(readOnlyKey).toBool(),
        object.value(modifiedKey).toBool(true),
    };
    for (const QJsonValue& path : object.value(openKey).toArray()) {
        glance.header.open.push_back(path.toString().toStdString());
    }
    glance.whole =
        hashOf(text.substr(head.size() + 1), glance.header.open) == hexOf(object, hashKey);
    return glance;
}

RecoveryContent readRecovery(std::string_view text) {
    RecoveryGlance glance = glanceAtRecovery(text);
    RecoveryContent content{std::move(glance.header), std::nullopt};
    if (glance.whole) {
        content.setup = parseProject(text.substr(headOf(text).size() + 1)).setup;
    }
    return content;
}

} // namespace sparkout
