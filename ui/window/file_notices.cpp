// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_notices.h"

#include "core/file/project_file.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/form/mark.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/session/document.h"
#include "ui/session/file_guard.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cstring>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

/// Unsaved work of programs that ended. Each item is recovered, deferred or discarded; a damaged
/// one can only be discarded, and its folder is shown.
class RecoveryDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(sparkout::RecoveryDialog)

public:
    /// `offeredElsewhere`: only discarded items are listed, as another window offers the others.
    RecoveryDialog(const RecoveryStore& store, std::vector<RecoveryItem> items,
                   bool offeredElsewhere, QWidget* parent = nullptr);

    [[nodiscard]] static QString offeredElsewhereText();

    /// The item to recover, after accept().
    [[nodiscard]] std::optional<RecoveryItem> chosen() const;

private:
    void fill();
    void discard();
    void followSelection();
    [[nodiscard]] int current() const; ///< index of the item; -1: none

    const RecoveryStore& m_store;
    std::vector<RecoveryItem> m_items;
    QTreeWidget* m_list;
    QPushButton* m_recover;
    QPushButton* m_discard;
};

QString stateText(const RecoveryItem& item) {
    switch (item.state) {
    case RecoveryItem::State::ready: return RecoveryDialog::tr("complete");
    case RecoveryItem::State::damaged: return RecoveryDialog::tr("damaged");
    case RecoveryItem::State::discarded: return RecoveryDialog::tr("discarded");
    }
    return {};
}

QString RecoveryDialog::offeredElsewhereText() {
    return tr("Another window already offers the unsaved work that was found. Answer there first, "
              "then try again.");
}

RecoveryDialog::RecoveryDialog(const RecoveryStore& store, std::vector<RecoveryItem> items,
                               bool offeredElsewhere, QWidget* parent)
    : QDialog(parent), m_store(store), m_items(std::move(items)), m_list(new QTreeWidget(this)) {
    setWindowTitle(tr("Recover work"));
    setHelpTopic(*this, QStringLiteral("files#recovery"));
    m_list->setAccessibleName(tr("Unsaved work"));
    m_list->setRootIsDecorated(false);
    m_list->setHeaderLabels({tr("Project"), tr("File"), tr("Kept at"), tr("State")});
    m_list->setTextElideMode(Qt::ElideMiddle);
    auto* folder =
        plainLabel(tr("Recovery files are kept in %1; discarded ones stay in %2 for %n days.",
                      nullptr, RecoveryStore::discardedDays)
                       .arg(m_store.folder(), m_store.discardedFolder()),
                   this);
    folder->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(this);
    m_recover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    m_discard = buttons->addButton(tr("&Discard"), QDialogButtonBox::ActionRole);
    auto* later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    m_recover->setObjectName(QStringLiteral("recover"));
    m_discard->setObjectName(QStringLiteral("discard"));
    later->setObjectName(QStringLiteral("later"));
    m_discard->setAutoDefault(false);
    m_recover->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_discard, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &RecoveryDialog::followSelection);
    connect(m_list, &QTreeWidget::itemActivated, m_recover, &QPushButton::click);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(plainLabel(tr("Work that was not saved was found. Recovering opens it here, "
                                    "still unsaved; your own files stay unchanged."),
                                 this));
    if (offeredElsewhere) {
        layout->addWidget(plainLabel(offeredElsewhereText(), this));
    }
    layout->addWidget(m_list, 1);
    layout->addWidget(folder);
    layout->addWidget(buttons);
    resize(760, 360);
    fill();
}

void RecoveryDialog::fill() {
    const QSignalBlocker blocker(m_list); // its rows do not match the items until it is full
    m_list->clear();
    for (const RecoveryItem& item : m_items) {
        const QString title = printableText(item.header.title.simplified());
        const QString path =
            item.header.path.isEmpty() ? tr("never saved") : printableText(item.header.path);
        const bool unknown = item.state == RecoveryItem::State::damaged && title.isEmpty();
        auto* row = new QTreeWidgetItem(m_list, {title.isEmpty() ? tr("Untitled") : title,
                                                 unknown ? printableText(item.file) : path,
                                                 momentText(item.header.when.toLocalTime()),
                                                 stateText(item)});
        row->setToolTip(1, unknown ? printableText(item.file) : path);
        if (item.state == RecoveryItem::State::damaged) {
            row->setIcon(3, markIcon(Mark::warning));
        }
    }
    m_list->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_list->header()->setStretchLastSection(false);
    for (const int column : {0, 2, 3}) {
        m_list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
    followSelection();
}

int RecoveryDialog::current() const {
    return m_list->indexOfTopLevelItem(m_list->currentItem());
}

void RecoveryDialog::followSelection() {
    const int index = current();
    const RecoveryItem* item = index < 0 ? nullptr : &m_items[std::size_t(index)];
    m_recover->setEnabled(item != nullptr && item->state != RecoveryItem::State::damaged);
    m_discard->setEnabled(item != nullptr && item->offer != nullptr);
}

void RecoveryDialog::discard() {
    const int index = current();
    if (index >= 0 && m_store.discard(m_items[std::size_t(index)].file)) {
        m_items.erase(m_items.begin() + index);
        fill();
        if (m_items.empty()) {
            reject(); // nothing is left to decide
        }
    }
    m_list->setFocus();
}

std::optional<RecoveryItem> RecoveryDialog::chosen() const {
    const int index = current();
    return index < 0 ? std::nullopt : std::optional(m_items[std::size_t(index)]);
}

} // namespace

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

namespace {

const QString readOnlyKey = QStringLiteral("readOnly");
const QString diskKey = QStringLiteral("disk");
const QString recoveredKey = QStringLiteral("recovered");
const QString keptRunsKey = QStringLiteral("keptRuns");
const QString autosaveKey = QStringLiteral("autosave");
const QString settingsKey = QStringLiteral("settings");
const QString lockKey = QStringLiteral("lock");

QString nameOf(const QString& path) {
    return printableText(QFileInfo(path).fileName());
}

} // namespace

FileNotices::FileNotices(Document& document, const Settings& settings, FileGuard& guard,
                         NoticeBar& bar, QWidget* window)
    : m_document(document), m_settings(settings), m_guard(guard), m_bar(bar), m_window(window) {
    connect(&m_document, &Document::replaced, this, [this] {
        removeAll({readOnlyKey, diskKey, recoveredKey, keptRunsKey});
        showStrangeLock();
    });
    connect(&m_guard, &FileGuard::changedOnDisk, this, &FileNotices::showChangedOnDisk);
    connect(&m_guard, &FileGuard::restoredOnDisk, this, &FileNotices::followDisk);
    connect(&m_settings.file(), &SettingsFile::foundDamaged, this,
            &FileNotices::showDamagedSettings, Qt::QueuedConnection);
    connect(&m_settings.file(), &SettingsFile::refused, this, &FileNotices::showRefusedSettings);
    connect(&m_guard, &FileGuard::autosaveFailed, this, &FileNotices::showAutosaveFailed);
    connect(&m_guard, &FileGuard::autosaved, this, [this] { m_bar.remove(autosaveKey); });
}

void FileNotices::removeAll(const QStringList& keys) {
    for (const QString& key : keys) {
        m_bar.remove(key);
    }
}

void FileNotices::followSaved() {
    removeAll({readOnlyKey, diskKey, recoveredKey});
    showStrangeLock();
}

void FileNotices::followDisk() {
    m_bar.remove(diskKey);
}

void FileNotices::showOpened(const Issues& issues) {
    if (m_document.readOnly()) {
        showReadOnly();
    }
    Issues faults;
    for (const Issue& issue : issues) {
        if (issue.severity == Severity::error && issue.path.starts_with("/runs/")) {
            faults.push_back(issue);
        }
    }
    m_bar.remove(keptRunsKey);
    if (faults.empty()) {
        return;
    }
    const QString path = m_document.filePath();
    m_bar.add({keptRunsKey,
               Mark::warning,
               [] {
                   return tr("Kept runs of this file contain inputs that this version refuses. "
                             "They stay in the file unchanged but cannot be computed again.");
               },
               {{[] { return tr("Show…"); },
                 [this, path, faults] {
                     FaultsDialog(path, faults, m_window, FaultsDialog::File::opened).exec();
                 }}}});
}

void FileNotices::showReadOnly() {
    const QString name = nameOf(m_document.filePath());
    m_bar.add(
        {readOnlyKey,
         Mark::none,
         [name] { return tr("“%1” is open read-only. Saving asks for another name.").arg(name); },
         {{[] { return tr("Save as…"); }, [this] { emit saveAsWanted(); }}}});
}

void FileNotices::showStrangeLock() {
    const QString strange = m_guard.strangeLock();
    m_bar.remove(lockKey);
    if (!strange.isEmpty()) {
        m_bar.add({lockKey, Mark::warning, [strange] { return strangeLockText(strange); }, {}});
    }
}

void FileNotices::showChangedOnDisk(const DiskState& state) {
    const QString name = nameOf(m_document.filePath());
    const Notice::Button reloadButton{[] { return tr("Reload"); }, [this] { emit reloadWanted(); }};
    if (state.kind != DiskState::Kind::file) {
        m_document.markUnsaved();
        m_bar.add({diskKey,
                   Mark::warning,
                   [name] {
                       return tr("“%1” was removed or renamed by another program. The project now "
                                 "exists only in this window.")
                           .arg(name);
                   },
                   {{[] { return tr("Save"); }, [this] { emit saveWanted(); }}}});
    } else if (m_document.modified()) {
        m_bar.add({diskKey,
                   Mark::warning,
                   [name] {
                       return tr("“%1” was changed by another program while it has unsaved "
                                 "changes here. Saving will ask which version counts.")
                           .arg(name);
                   },
                   {reloadButton}});
    } else {
        m_bar.add(
            {diskKey,
             Mark::warning,
             [name] { return tr("“%1” was changed by another program. Reload it?").arg(name); },
             {reloadButton,
              {[] { return tr("Keep mine"); }, [this] { m_document.markUnsaved(); }}}});
    }
}

void FileNotices::showRecovered(const RecoveryHeader& header) {
    m_bar.add({recoveredKey,
               Mark::none,
               [header] {
                   const QString when = momentText(header.when.toLocalTime());
                   return header.path.isEmpty()
                              ? tr("This is recovered work of %1. It is not saved yet.").arg(when)
                              : tr("This is recovered work of %1 on “%2”. It is not saved yet; the "
                                   "file is unchanged.")
                                    .arg(when, nameOf(header.path));
               },
               {{[] { return tr("Save"); }, [this] { emit saveWanted(); }}}});
}

void FileNotices::showRefusedSettings(const FileError& error) {
    m_bar.add({settingsKey,
               Mark::error,
               [error] { return tr("The settings were not kept. %1").arg(saveErrorText(error)); },
               {}});
}

/// Includes those that another instance, or this one at its end, found damaged and put aside.
void FileNotices::showDamagedSettings() {
    if (const QStringList aside = m_settings.file().takeDamaged(); !aside.isEmpty()) {
        m_bar.add({settingsKey,
                   Mark::warning,
                   [aside] {
                       return tr("The settings file was damaged and is kept as %1. "
                                 "Settings that could not be read have their default values.")
                           .arg(printableText(aside.join(QStringLiteral(", "))));
                   },
                   {}});
    }
    if (const auto& error = m_settings.file().unreadable()) {
        m_bar.add({settingsKey,
                   Mark::warning,
                   [error = *error] {
                       if (error.step == FileStep::backup) {
                           return tr("The settings file is damaged and could not be renamed (%1): "
                                     "%2. It is left unchanged; the default settings are used, and "
                                     "changes to them are not saved.")
                               .arg(QString::fromLocal8Bit(std::strerror(error.systemError)),
                                    printableText(QString::fromStdString(error.path)));
                       }
                       return tr("The settings are the default ones: %1").arg(readErrorText(error));
                   },
                   {}});
    }
}

void FileNotices::showAutosaveFailed(const FileError& error) {
    m_bar.add(
        {autosaveKey,
         Mark::warning,
         [error] {
             return tr("Unsaved work is not protected from a crash: %1").arg(saveErrorText(error));
         },
         {}});
}

} // namespace sparkout
