// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/guard_questions.h"

#include "ui/dialogs/disk_wait.h"
#include "ui/files/guarded_file.h"

namespace sparkout {

std::optional<GuardQuestions::Opening> GuardQuestions::wayToOpen(const QString& path) {
    switch (m_file.claim(path)) {
    case GuardedFile::Access::write: return Opening::write;
    case GuardedFile::Access::readOnly: return Opening::readOnly;
    case GuardedFile::Access::conflict: break;
    }
    switch (askLocked(m_window, path, m_file.holder())) {
    case LockedAnswer::readOnly: return Opening::readOnly;
    case LockedAnswer::copy: m_file.dropClaim(); return Opening::copy;
    case LockedAnswer::takeOver:
        return m_file.takeOver() == GuardedFile::Access::write ? Opening::write : Opening::readOnly;
    case LockedAnswer::cancel: break;
    }
    m_file.dropClaim();
    return {};
}

/// Asks the user about every obstacle to writing the file.
SaveAnswer GuardQuestions::clearTheWay(const QString& path, Reloading reloading) {
    if (m_file.claim(path) == GuardedFile::Access::conflict) {
        const SaveAnswer answer = askSaveLocked(m_window, path, m_file.holder());
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        (void)m_file.takeOver();
    }
    if (const auto state = m_file.changedOutside(path)) {
        const SaveAnswer answer = askChangedOutside(
            m_window, path,
            state->kind == DiskState::Kind::missing ? Outside::removed : Outside::changed,
            reloading);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
    }
    if (const std::uint64_t links = linkCount(path); links > 1 && m_linksAccepted != path) {
        const SaveAnswer answer = askHardLinks(m_window, path, links);
        if (answer != SaveAnswer::proceed) {
            return answer;
        }
        m_linksAccepted = path;
    }
    return SaveAnswer::proceed;
}

GuardQuestions::Outcome
GuardQuestions::save(const QString& path, Reloading reloading,
                     const std::function<std::optional<FileError>()>& write) {
    m_error.reset();
    do {
        switch (clearTheWay(path, reloading)) {
        case SaveAnswer::proceed: break;
        case SaveAnswer::elsewhere: m_file.dropClaim(); return Outcome::elsewhere;
        case SaveAnswer::reload: m_file.dropClaim(); return Outcome::reload;
        case SaveAnswer::cancel: m_file.dropClaim(); return Outcome::cancelled;
        }
        m_wait.during([&] { m_error = write(); });
        // Somebody was quicker than the answer: the next look at the disk asks again.
    } while (m_error && m_error->step == FileStep::changed && m_file.changedOutside(path));
    return m_error ? Outcome::failed : Outcome::saved;
}

GuardQuestions::Outcome GuardQuestions::save(const QString& path, Reloading reloading,
                                             const MakeContent& make) {
    return save(path, reloading, [&] { return m_file.write(path, make); });
}

} // namespace sparkout
