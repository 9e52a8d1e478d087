// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lessons_dialog.h"

#include "core/file/project_file.h"
#include "core/lesson/lesson_file.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_text.h"
#include "ui/session/own_lessons.h"

#include <QDir>
#include <QFile>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
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

namespace {

constexpr int longestStudentName = 100, studentDialogWidth = 460;

} // namespace

StudentDialog::StudentDialog(const Lesson& lesson, const QString& name, const QString& group,
                             QWidget* parent)
    : QDialog(parent)
    , m_name(new QLineEdit(name, this))
    , m_group(new QLineEdit(group, this))
    , m_variant(new QSpinBox(this)) {
    setHelpTopic(*this, QStringLiteral("lessons#begin"));
    setWindowTitle(tr("Begin the laboratory work"));
    auto* title = new QLabel(LessonText::of(lesson.title), this);
    auto* aim = new QLabel(LessonText::markup(lesson.aim), this);
    auto* how = new QLabel(tr("Next you choose the file of your work; hand in that file. Every "
                              "answer is saved in it at once."),
                           this);
    for (QLabel* label : {title, aim, how}) {
        label->setWordWrap(true);
    }
    title->setTextFormat(Qt::PlainText);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    m_name->setObjectName(QStringLiteral("studentName"));
    m_group->setObjectName(QStringLiteral("studentGroup"));
    m_variant->setObjectName(QStringLiteral("studentVariant"));
    m_name->setMaxLength(longestStudentName);
    m_group->setMaxLength(longestStudentName);
    m_variant->setRange(1, mostVariants);
    m_variant->setVisible(lesson.variants.has_value());
    auto* form = new QFormLayout;
    form->addRow(tr("&Surname and first name"), m_name);
    form->addRow(tr("&Group"), m_group);
    if (lesson.variants) {
        form->addRow(tr("&Variant"), m_variant);
    }
    auto* buttons = new AnswerButtons(tr("&Begin…"), tr("&Cancel"), this);
    m_begin = buttons->acceptButton();
    connect(m_name, &QLineEdit::textChanged, this, &StudentDialog::showWhole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::margin);
    layout->addWidget(title);
    layout->addWidget(aim);
    layout->addLayout(form);
    layout->addWidget(how);
    layout->addStretch(1);
    layout->addWidget(buttons);
    resize(studentDialogWidth, sizeHint().height());
    showWhole();
}

void StudentDialog::showWhole() {
    m_begin->setEnabled(!name().isEmpty());
}

QString StudentDialog::name() const {
    return m_name->text().simplified();
}

QString StudentDialog::group() const {
    return m_group->text().simplified();
}

int StudentDialog::variant() const {
    return m_variant->value();
}

} // namespace sparkout
