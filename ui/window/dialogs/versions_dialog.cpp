// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/versions_dialog.h"

#include "ui/kit/answer_buttons.h"
#include "ui/kit/help_topic.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace sparkout {

VersionsDialog::VersionsDialog(const QString& project, std::vector<EarlierVersion> versions,
                               QWidget* parent)
    : QDialog(parent), m_versions(std::move(versions)), m_list(new QTreeWidget(this)) {
    setWindowTitle(tr("Earlier versions"));
    setHelpTopic(*this, QStringLiteral("files#versions"));
    auto* head = new QLabel(m_versions.empty()
                                ? tr("No earlier version of “%1” is kept yet.")
                                      .arg(printableText(QFileInfo(project).fileName()))
                                : tr("Versions of “%1” that a save has replaced. The chosen one is "
                                     "opened as a copy; the file stays as it is.")
                                      .arg(printableText(QFileInfo(project).fileName())),
                            this);
    head->setTextFormat(Qt::PlainText);
    head->setWordWrap(true);
    m_list->setAccessibleName(tr("Earlier versions"));
    m_list->setRootIsDecorated(false);
    m_list->setHeaderLabels({tr("Replaced at"), tr("Size"), tr("File")});
    m_list->setTextElideMode(Qt::ElideMiddle);
    for (const EarlierVersion& earlier : m_versions) {
        auto* row =
            new QTreeWidgetItem(m_list, {momentText(earlier.when.toLocalTime()),
                                         sizeText(earlier.bytes), printableText(earlier.file)});
        row->setToolTip(2, printableText(earlier.file));
    }
    for (const int column : {0, 1}) {
        m_list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
    auto* buttons = new AnswerButtons(tr("&Open a copy"), tr("&Cancel"), this);
    buttons->acceptButton()->setEnabled(!m_versions.empty());
    connect(m_list, &QTreeWidget::itemActivated, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(head);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resize(720, 320);
}

QString VersionsDialog::chosenFile() const {
    const int index = m_list->indexOfTopLevelItem(m_list->currentItem());
    return index < 0 ? QString() : m_versions[std::size_t(index)].file;
}

} // namespace sparkout
