// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/student_dialog.h"

#include "ui/kit/answer_buttons.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_text.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

namespace sparkout {

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
    auto* how = new QLabel(
        tr("In the next step you choose the file your work is kept in: you hand that file in. "
           "Every answer is saved in it at once."),
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
