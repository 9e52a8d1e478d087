// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_watch.h"

#include <QFileInfo>

namespace sparkout {

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

} // namespace sparkout
