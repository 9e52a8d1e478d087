// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/on_disk.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QString>
#include <QTemporaryDir>

#ifdef Q_OS_WIN
#include <fcntl.h>
#include <io.h>
#include <share.h>
#else
#include <csignal>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

/// Trouble with disks and rights, made on purpose and in folders of the test's own.
namespace sparkout::trouble {

using on_disk::write;

inline QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("<not there>");
}

/// What is in a folder, hidden files too.
inline QStringList entries(const QString& folder) {
    return QDir(folder).entryList(
        QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot, QDir::Name);
}

/// The lock of a program that no longer runs. What a lock calls this computer is asked of one.
inline QByteArray deadLock() {
    const QTemporaryDir folder;
    QLockFile lock(folder.filePath(QStringLiteral("any")));
    qint64 process = 0;
    QString host, program;
    if (!lock.tryLock() || !lock.getLockInfo(&process, &host, &program)) {
        qFatal("the test cannot lock a file");
    }
    return "999999999\nsparkout\n" + host.toUtf8() + "\n\n\n";
}

/// What putStrange() can make here.
inline QStringList strangeKinds() {
#ifdef Q_OS_WIN
    return {QStringLiteral("huge"), QStringLiteral("folder")};
#else
    return {QStringLiteral("pipe"), QStringLiteral("zero"), QStringLiteral("huge"),
            QStringLiteral("folder"), QStringLiteral("dangling")};
#endif
}

#ifdef Q_OS_WIN

// A user without rights, a disk that is full and a pipe among the files are made on POSIX alone.
// What stands in the way of a file here is that another program has it open.

/// While it lives, a file is open elsewhere: nobody else reads or writes it, or nobody replaces it.
class Held {
public:
    enum class Against { everything, replacing };
    Held(const QString& path, Against against)
        : m_file(::_wsopen(QDir::toNativeSeparators(path).toStdWString().c_str(),
                           _O_RDWR | _O_BINARY,
                           against == Against::everything ? _SH_DENYRW : _SH_DENYNO)) {
        if (m_file < 0) {
            qFatal("the test cannot hold %s", qPrintable(path));
        }
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() { ::_close(m_file); }

private:
    int m_file;
};

inline void putStrange(const QString& kind, const QString& path) {
    bool made = false;
    if (kind == u"folder") {
        made = QDir().mkdir(path);
    } else if (kind == u"huge") {
        write(path, {});
        made = QFile::resize(path, qint64{2} << 30);
    }
    if (!made) {
        qFatal("the test cannot make %s", qPrintable(path));
    }
}

/// Whether its owner may write a file is all that Windows has of a mode.
inline void setMode(const QString& path, unsigned mode) {
    QFile::Permissions allowed = QFile::ReadOwner | QFile::ReadUser;
    if ((mode & 0200U) != 0) {
        allowed |= QFile::WriteOwner | QFile::WriteUser;
    }
    if (!QFile::setPermissions(path, allowed)) {
        qFatal("the test cannot set the attributes of %s", qPrintable(path));
    }
}

#else

constexpr uid_t nobody = 65534;

inline bool mayBecomeAnother() {
    return ::geteuid() == 0;
}

/// While it lives, root counts as nobody: root may write anything, so nothing could be forbidden.
class Unprivileged {
public:
    Unprivileged() : m_root(::geteuid() == 0 && ::seteuid(nobody) == 0) {}
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged() {
        if (m_root && ::seteuid(0) != 0) {
            qFatal("the test cannot become root again");
        }
    }

private:
    bool m_root;
};

/// Something that is no ordinary file: "pipe", "zero" (a link to /dev/zero), "huge" (2 GB of
/// nothing), "folder" or "dangling" (a link to nowhere).
inline void putStrange(const QString& kind, const QString& path) {
    const QByteArray name = QFile::encodeName(path);
    bool made = false;
    if (kind == u"pipe") {
        made = ::mkfifo(name.constData(), 0600) == 0;
    } else if (kind == u"zero") {
        made = ::symlink("/dev/zero", name.constData()) == 0;
    } else if (kind == u"dangling") {
        made = ::symlink("/nowhere/at/all", name.constData()) == 0;
    } else if (kind == u"folder") {
        made = ::mkdir(name.constData(), 0700) == 0;
    } else {
        write(path, {});
        made = ::truncate(name.constData(), off_t{2} << 30) == 0;
    }
    if (!made) {
        qFatal("the test cannot make %s", name.constData());
    }
}

/// Gives a file or folder to the user that Unprivileged turns into.
inline void giveAway(const QString& path) {
    if (::geteuid() == 0 && ::chown(QFile::encodeName(path).constData(), nobody, nobody) != 0) {
        qFatal("the test cannot give away %s", qPrintable(path));
    }
}

inline void setMode(const QString& path, mode_t mode) {
    if (::chmod(QFile::encodeName(path).constData(), mode) != 0) {
        qFatal("the test cannot set the mode of %s", qPrintable(path));
    }
}

/// While it lives, no file takes a byte: every write fails, as on a disk that is full.
class NoBytes {
public:
    NoBytes() {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit none{0, m_before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    NoBytes(const NoBytes&) = delete;
    NoBytes& operator=(const NoBytes&) = delete;
    ~NoBytes() { ::setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

/// A file system of our own of so many KB, seen by this process only. Call it before the first
/// thread is started. False where that is not allowed.
inline bool mountSmallDisk(const QString& folder, int kilobytes) {
    if (::unshare(CLONE_NEWNS) != 0
        || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
        return false;
    }
    const QByteArray options = "size=" + QByteArray::number(kilobytes) + "k,mode=1777";
    return ::mount("sparkout", QFile::encodeName(folder).constData(), "tmpfs", 0,
                   options.constData())
           == 0;
}

#endif

} // namespace sparkout::trouble
