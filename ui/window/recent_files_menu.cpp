// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recent_files_menu.h"
#include "ui/kit/theme.h"

#include "ui/kit/theme_icon.h"
#include "ui/session/settings.h"
#include "ui/text/texts.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>

namespace sparkout {

namespace {

/// The name, and the folder to distinguish equal names, without mnemonics.
QString shown(const QString& path) {
    const QFileInfo file(path);
    QString folder = file.path();
    if (folder == QDir::homePath() || folder.startsWith(QDir::homePath() + u'/')) {
        folder.replace(0, QDir::homePath().size(), u'~');
    }
    constexpr qsizetype longest = 60;
    if (folder.size() > longest) {
        folder = folder.left(longest / 2) + u'…' + folder.right(longest / 2);
    }
    QString text = file.fileName() + QStringLiteral("  —  ") + folder;
    return printableText(text).replace(u'&', QStringLiteral("&&"));
}

} // namespace

RecentFilesMenu::RecentFilesMenu(Settings& settings, QWidget* parent)
    : QMenu(parent)
    , m_settings(settings)
    , m_separator(addSeparator())
    , m_removeMissing(new QAction(this))
    , m_clear(new QAction(this)) {
    setIcon(themeIcon(u"open"));
    setToolTipsVisible(true);
    addActions({m_removeMissing, m_clear});
    connect(this, &QMenu::aboutToShow, this, &RecentFilesMenu::fill);
    connect(m_removeMissing, &QAction::triggered, this, &RecentFilesMenu::removeMissing);
    connect(m_clear, &QAction::triggered, this, [this] {
        m_settings.setRecentFiles({});
        fill();
    });
    retranslate();
    fill();
}

void RecentFilesMenu::fill() {
    for (const Entry& entry : m_entries) {
        removeAction(entry.action);
        entry.action->deleteLater(); // it may be triggering at this moment
    }
    m_entries.clear();
    for (const QString& path : m_settings.recentFiles()) {
        auto* action = new QAction(this);
        action->setToolTip(printableText(path));
        connect(action, &QAction::triggered, this, [this, path] { emit chosen(path); });
        insertAction(m_separator, action);
        m_entries.push_back({path, action});
    }
    m_clear->setEnabled(!m_entries.empty());
    menuAction()->setEnabled(!m_entries.empty());
    showMissing(m_missing);
    lookForFiles();
}

void RecentFilesMenu::lookForFiles() {
    m_background.start([this, paths = m_settings.recentFiles()] {
        QStringList missing;
        for (const QString& path : paths) {
            if (!QFileInfo::exists(path)) {
                missing += path;
            }
        }
        return Background::Answer([this, missing] { showMissing(missing); });
    });
}

void RecentFilesMenu::showMissing(const QStringList& missing) {
    m_missing = missing;
    int digit = 0;
    bool any = false;
    for (const Entry& entry : m_entries) {
        const bool there = !missing.contains(entry.path);
        const QString text = QStringLiteral("&%1  %2").arg(++digit).arg(shown(entry.path));
        entry.action->setText(there ? text : tr("%1 (missing)").arg(text));
        entry.action->setEnabled(there);
        any = any || !there;
    }
    m_removeMissing->setEnabled(any);
}

void RecentFilesMenu::removeMissing() {
    QStringList paths = m_settings.recentFiles();
    for (const QString& path : m_missing) {
        paths.removeAll(path);
    }
    m_settings.setRecentFiles(paths);
    fill();
}

void RecentFilesMenu::retranslate() {
    setTitle(tr("Open &recent"));
    m_removeMissing->setText(tr("Remove the &missing ones"));
    m_clear->setText(tr("&Clear the list"));
}

void RecentFilesMenu::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showMissing(m_missing);
    }
    QMenu::changeEvent(event);
}

} // namespace sparkout
