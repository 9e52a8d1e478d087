// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/examples_dialog.h"

#include "core/format/project_file.h"
#include "core/study/evaluate.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/example_texts.h"
#include "ui/text/texts.h"
#include "ui/views/verdict/verdict_text.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

QStringList ExamplesDialog::paths() {
    const QDir folder(QStringLiteral(":/examples"));
    QStringList list;
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        list += folder.filePath(name);
    }
    return list;
}

QByteArray ExamplesDialog::textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

ExamplesDialog::ExamplesDialog(QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_notes(new QLabel) {
    setHelpTopic(*this, QStringLiteral("start#examples"));
    setWindowTitle(tr("Example gallery"));
    m_list->setAccessibleName(tr("Examples"));
    m_list->setIconSize({metrics::iconLarge, metrics::iconLarge});
    m_list->setSpacing(metrics::hair);
    m_notes->setTextFormat(Qt::PlainText);
    m_notes->setWordWrap(true);
    m_notes->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_notes->setMargin(metrics::margin);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(m_notes);
    scroll->setWidgetResizable(true);
    scroll->setAccessibleName(tr("Notes of the example"));
    auto* hint =
        new QLabel(tr("The example is opened as a copy; the shipped one stays as it is."), this);
    hint->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(this);
    auto* open = buttons->addButton(tr("&Open a copy"), QDialogButtonBox::AcceptRole);
    buttons->addButton(tr("&Cancel"), QDialogButtonBox::RejectRole);
    open->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(m_list, &QListWidget::currentRowChanged, this, &ExamplesDialog::showNotes);
    auto* body = new QHBoxLayout;
    body->addWidget(m_list, 1);
    body->addWidget(scroll, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body, 1);
    layout->addWidget(hint);
    layout->addWidget(buttons);
    resize(860, 440);
    fill();
}

void ExamplesDialog::fill() {
    for (const QString& path : paths()) {
        const QByteArray text = textOf(path);
        ReadResult read = readProject({text.constData(), static_cast<std::size_t>(text.size())});
        if (!read.project) {
            continue;
        }
        const Choice& choice = read.project->operation->choice;
        new QListWidgetItem(
            themeIcon(QString::fromLatin1(choice.key)),
            tr("%1\n%2").arg(exampleTitle(read.project->title), choiceText(choice.label)), m_list);
        m_entries.push_back({path, std::move(*read.project)});
    }
    m_list->setCurrentRow(0);
}

void ExamplesDialog::showNotes() {
    const int row = m_list->currentRow();
    if (row < 0) {
        m_notes->clear();
        return;
    }
    const Project& project = m_entries[std::size_t(row)].project;
    const OutcomePtr outcome = evaluate(project, {});
    m_notes->setText(tr("%1. %2. %3.\n\n%4")
                         .arg(verdict::time(outcome->result), verdict::status(outcome->result),
                              verdict::overall(*outcome), exampleNotes(project.notes)));
}

QByteArray ExamplesDialog::chosenText() const {
    const int row = m_list->currentRow();
    return row < 0 ? QByteArray() : textOf(m_entries[std::size_t(row)].path);
}

QString ExamplesDialog::chosenTitle() const {
    const int row = m_list->currentRow();
    return row < 0 ? QString() : exampleTitle(m_entries[std::size_t(row)].project.title);
}

} // namespace sparkout
