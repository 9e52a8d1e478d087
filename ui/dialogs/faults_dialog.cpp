// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/faults_dialog.h"

#include "ui/fields/mark.h"
#include "ui/kit/help_topic.h"
#include "ui/text/texts.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace sparkout {

QStringList FaultsDialog::lines(const Issues& issues) {
    QStringList list;
    for (const Issue& issue : issues) {
        const QString path = QString::fromStdString(issue.path);
        const QString where = locationText(issue.path);
        list += path.isEmpty() ? fileIssueText(issue)
                : where.isEmpty() || where == path.section(u'/', -1)
                    ? tr("%1: %2").arg(path, fileIssueText(issue))
                    : tr("%1 (%2): %3").arg(where, path, fileIssueText(issue));
    }
    return list;
}

FaultsDialog::FaultsDialog(const QString& file, const Issues& issues, QWidget* parent, File state)
    : QDialog(parent) {
    setHelpTopic(*this, QStringLiteral("files#faults"));
    const QString name = printableText(QFileInfo(file).fileName());
    setWindowTitle(state == File::refused ? tr("The file was not opened")
                                          : tr("Faults of the file"));
    auto* head = new QLabel(state == File::refused
                                ? tr("“%1” is refused for these reasons. The project in the window "
                                     "is unchanged.")
                                      .arg(name)
                                : tr("“%1” is open, but these values are refused:").arg(name),
                            this);
    head->setTextFormat(Qt::PlainText);
    head->setWordWrap(true);
    auto* list = new QListWidget(this);
    list->setWordWrap(true);
    list->setAccessibleName(tr("Faults of the file"));
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const QStringList texts = lines(issues);
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const bool isError = issues[std::size_t(i)].severity == Severity::error;
        new QListWidgetItem(markIcon(isError ? Mark::error : Mark::warning), texts[i], list);
    }
    auto* buttons = new QDialogButtonBox(this);
    auto* copy = buttons->addButton(tr("&Copy the list"), QDialogButtonBox::ActionRole);
    auto* close = buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
    copy->setAutoDefault(false);
    close->setDefault(true);
    connect(copy, &QPushButton::clicked, this,
            [texts] { QGuiApplication::clipboard()->setText(texts.join(u'\n')); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(head);
    layout->addWidget(list, 1);
    layout->addWidget(buttons);
    resize(640, 320);
}

} // namespace sparkout
