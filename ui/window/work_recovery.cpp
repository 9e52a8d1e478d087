// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/work_recovery.h"

#include "core/format/project_file.h"
#include "ui/dialogs/disk_wait.h"
#include "ui/dialogs/file_questions.h"
#include "ui/files/file_guard.h"
#include "ui/session/document.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/recovery_dialog.h"
#include "ui/window/file_notices.h"

#include <utility>
#include <variant>

namespace sparkout {

WorkRecovery::WorkRecovery(Document& document, FileGuard& guard, FileNotices& notices,
                           DiskWait& wait, QWidget* window)
    : m_document(document), m_guard(guard), m_notices(notices), m_wait(wait), m_window(window) {}

bool WorkRecovery::offer(bool alsoDiscarded) {
    const RecoveryStore* store = m_guard.recovery();
    if (store == nullptr) {
        return false;
    }
    std::vector<RecoveryItem> items;
    bool offeredElsewhere = false;
    m_wait.aside([&] {
        items = store->left(&offeredElsewhere);
        if (alsoDiscarded) {
            for (RecoveryItem& item : store->discarded()) {
                items.push_back(std::move(item));
            }
        }
    });
    if (items.empty()) {
        if (alsoDiscarded) {
            showFailure(m_window, tr("Recover work"),
                        offeredElsewhere ? RecoveryDialog::offeredElsewhereText()
                                         : tr("No unsaved work was found."));
        }
        return false;
    }
    RecoveryDialog dialog(*store, std::move(items), offeredElsewhere, m_window);
    const bool accepted = dialog.exec() == QDialog::Accepted;
    const auto chosen = dialog.chosen();
    return accepted && chosen && recover(*chosen);
}

bool WorkRecovery::recover(const RecoveryItem& item) {
    std::variant<std::string, FileError> read;
    RecoveryContent content;
    m_wait.aside([&] {
        read = readFile(systemPath(item.file), limits::fileBytes + (64u << 10));
        if (const auto* text = std::get_if<std::string>(&read)) {
            content = readRecovery(*text);
        }
    });
    if (!content.setup) { // it was complete when it was listed
        const auto* error = std::get_if<FileError>(&read);
        showFailure(m_window, tr("The file was not opened"),
                    error ? readErrorText(*error)
                          : tr("“%1” is damaged.").arg(printableText(item.file)));
        return false;
    }
    // Without a lock the work continues in another recovery file; this one stays.
    const RecoveryStore& store = *m_guard.recovery();
    RecoveryClaimPtr claim = store.claim(item);
    if (!claim && store.inUse(item)) {
        showFailure(m_window, tr("The file was not opened"),
                    tr("Another window has recovered this work meanwhile."));
        return false;
    }
    const RecoveryHeader& header = content.header;
    const bool readOnly =
        !header.path.isEmpty()
        && (m_guard.claim(header.path) != FileGuard::Access::write || header.readOnly);
    m_document.recover(std::move(*content.setup), header.path, header.diskHash, readOnly,
                       header.open);
    m_guard.adoptRecovery(std::move(claim));
    if (readOnly) {
        m_notices.showReadOnly();
    }
    m_notices.showRecovered(header);
    return true;
}

} // namespace sparkout
