// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lessons_dialog.h"

#include "core/format/project_file.h"
#include "core/lesson/lesson_file.h"
#include "ui/files/own_lessons.h"
#include "ui/kit/answer_buttons.h"
#include "ui/kit/help_topic.h"
#include "ui/lesson/lesson_text.h"

#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

QStringList LessonsDialog::paths() {
    const QDir folder(QStringLiteral(":/lessons"));
    QStringList list;
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        list += folder.filePath(name);
    }
    return list;
}

LessonsDialog::LessonsDialog(const QString& settingsFolder, QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)), m_about(new QTextBrowser(this)) {
    setHelpTopic(*this, QStringLiteral("lessons"));
    setWindowTitle(tr("Laboratory works"));
    m_list->setObjectName(QStringLiteral("lessons"));
    m_list->setAccessibleName(tr("Laboratory works"));
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_about->setAccessibleName(tr("About the laboratory work"));
    m_about->setOpenLinks(false);
    connect(m_list, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(m_list, &QListWidget::currentRowChanged, this, &LessonsDialog::showChosen);
    auto* body = new QHBoxLayout;
    body->addWidget(m_list, 1);
    body->addWidget(m_about, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body, 1);
    auto* buttons = new AnswerButtons(tr("&Begin…"), tr("&Cancel"), this);
    layout->addWidget(buttons);
    resize(860, 480);
    for (const QString& path : paths() + ownLessons(settingsFolder)) {
        QFile file(path);
        const QByteArray text = file.open(QIODevice::ReadOnly)
                                    ? file.read(qint64{limits::fileBytes} + 1)
                                    : QByteArray();
        ReadLesson read = readLessonOfAnybody({text.constData(), std::size_t(text.size())});
        if (read.lesson) {
            m_list->addItem(LessonText::of(read.lesson->title));
            m_entries.push_back({path, std::move(*read.lesson)});
        }
    }
    m_list->setCurrentRow(0);
    buttons->acceptButton()->setEnabled(!m_entries.empty());
}

void LessonsDialog::showChosen() {
    const int row = m_list->currentRow();
    if (row < 0) {
        m_about->clear();
        return;
    }
    const Lesson& lesson = m_entries[std::size_t(row)].lesson;
    m_about->setHtml(
        QStringLiteral("<p>%1</p><p>%2</p>")
            .arg(LessonText::markup(lesson.aim), tr("Steps: %1. Points: %2.")
                                                     .arg(lesson.steps.size())
                                                     .arg(LessonText::points(lesson.points()))));
}

QString LessonsDialog::chosen() const {
    const int row = m_list->currentRow();
    return row < 0 ? QString() : m_entries[std::size_t(row)].path;
}

} // namespace sparkout
