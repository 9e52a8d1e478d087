// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions.h"

#include "ui/session/document.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace sparkout {

Actions::Actions(QMainWindow& window)
    : QObject(&window)
    , newTraverse(make(u"traverse", QKeySequence::New))
    , newPlunge(make(u"plunge", Qt::CTRL | Qt::SHIFT | Qt::Key_N))
    , open(make(u"open", QKeySequence::Open))
    , examples(make(u"examples", Qt::CTRL | Qt::Key_E))
    , save(make(u"save", QKeySequence::Save))
    , saveAs(make(u"save", Qt::CTRL | Qt::SHIFT | Qt::Key_S))
    , quit(make(u"", Qt::CTRL | Qt::Key_Q))
    , undo(make(u"undo", QKeySequence::Undo))
    , redo(make(u"redo", QKeySequence::Redo))
    , english(make(u""))
    , russian(make(u""))
    , resetLayout(make(u""))
    , about(make(u"sparkout")) {
    quit->setMenuRole(QAction::QuitRole);
    about->setMenuRole(QAction::AboutRole);
    auto* languages = new QActionGroup(this);
    for (QAction* action : {english, russian}) {
        action->setCheckable(true);
        languages->addAction(action);
    }
    buildMenus(window);
    buildToolBar(window);
    retranslate();
}

QAction* Actions::make(const char16_t* icon, const QKeySequence& keys) {
    auto* action = new QAction(this);
    const QStringView name(icon);
    if (!name.isEmpty()) {
        action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(name)));
    }
    action->setShortcut(keys);
    return action;
}

void Actions::buildMenus(QMainWindow& window) {
    QMenuBar& bar = *window.menuBar();
    m_file = bar.addMenu(QString());
    m_new = m_file->addMenu(QIcon(QStringLiteral(":/icons/new.svg")), QString());
    m_new->addActions({newTraverse, newPlunge});
    m_file->addActions({open, examples});
    m_file->addSeparator();
    m_file->addActions({save, saveAs});
    m_file->addSeparator();
    m_file->addAction(quit);
    m_edit = bar.addMenu(QString());
    redo->setShortcuts({QKeySequence(QKeySequence::Redo), QKeySequence(QStringLiteral("Ctrl+Y"))});
    m_edit->addActions({undo, redo});
    m_view = bar.addMenu(QString());
    m_language = m_view->addMenu(QString());
    m_language->addActions({english, russian});
    m_view->addAction(resetLayout);
    m_view->addSeparator();
    m_help = bar.addMenu(QString());
    m_help->addAction(about);
}

void Actions::buildToolBar(QMainWindow& window) {
    m_bar = window.addToolBar(QString());
    m_bar->setObjectName(QStringLiteral("toolBar"));
    m_bar->setMovable(false);
    m_bar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_bar->setIconSize({22, 22});
    m_bar->addAction(m_new->menuAction());
    m_bar->addActions({open, save});
    m_bar->addSeparator();
    m_bar->addActions({undo, redo});
    m_bar->addSeparator();
    m_bar->addAction(examples);
    if (auto* button = qobject_cast<QToolButton*>(m_bar->widgetForAction(m_new->menuAction()))) {
        button->setPopupMode(QToolButton::InstantPopup);
    }
}

void Actions::addDocks(const QList<QAction*>& toggles) {
    m_view->addActions(toggles);
}

void Actions::follow(const Document& document, bool refusedText) {
    undo->setEnabled(document.canUndo() || refusedText);
    redo->setEnabled(document.canRedo());
    const QString undone = refusedText ? tr("refused text") : document.undoText();
    const QString redone = document.redoText();
    undo->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undone));
    redo->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redone));
    undo->setIconText(tr("Undo"));
    redo->setIconText(tr("Redo"));
}

void Actions::retranslate() {
    m_file->setTitle(tr("&File"));
    m_edit->setTitle(tr("&Edit"));
    m_view->setTitle(tr("&View"));
    m_help->setTitle(tr("&Help"));
    m_new->setTitle(tr("&New"));
    m_new->menuAction()->setToolTip(tr("New project"));
    m_language->setTitle(tr("&Language"));
    m_bar->setWindowTitle(tr("Tool bar"));
    newTraverse->setText(tr("&Traverse grinding"));
    newPlunge->setText(tr("&Plunge grinding"));
    open->setText(tr("&Open…"));
    examples->setText(tr("&Example gallery…"));
    save->setText(tr("&Save"));
    saveAs->setText(tr("Save &as…"));
    quit->setText(tr("&Quit"));
    english->setText(QStringLiteral("English"));
    russian->setText(QStringLiteral("Русский"));
    resetLayout->setText(tr("&Reset the layout"));
    about->setText(tr("&About Sparkout"));
}

void Actions::showLanguage(const QString& code) {
    (code == u"ru" ? russian : english)->setChecked(true);
}

} // namespace sparkout
