// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/entry_name_dialog.h"

#include "ui/kit/dialog_parts.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

constexpr int longestEntryName = 200;
constexpr int nameDialogWidth = 420;

} // namespace

EntryNameDialog::EntryNameDialog(const QString& title, const QString& name,
                                 std::function<Answer(const QString&)> judge, QWidget* parent)
    : QDialog(parent)
    , m_judge(std::move(judge))
    , m_name(new QLineEdit(name, this))
    , m_remark(plainLabel({}, this)) {
    setWindowTitle(title);
    m_name->setObjectName(QStringLiteral("entryName"));
    m_name->setMaxLength(longestEntryName);
    m_name->selectAll();
    auto* label = new QLabel(tr("&Name in your catalogue:"), this);
    label->setBuddy(m_name);
    m_name->setAccessibleName(tr("Name in your catalogue"));
    m_remark->setAccessibleName(tr("Action"));
    m_remark->setMinimumHeight(m_remark->fontMetrics().lineSpacing() * 2);
    m_remark->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new AnswerButtons(tr("&Keep"), tr("&Cancel"), this);
    m_keep = buttons->acceptButton();
    m_keep->setObjectName(QStringLiteral("keepName"));
    connect(m_name, &QLineEdit::textChanged, this, &EntryNameDialog::judge);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(label);
    layout->addWidget(m_name);
    layout->addWidget(m_remark);
    layout->addWidget(buttons);
    resize(nameDialogWidth, sizeHint().height());
    EntryNameDialog::judge();
}

QString EntryNameDialog::name() const {
    return m_name->text().simplified();
}

void EntryNameDialog::judge() {
    const Answer answer = name().isEmpty() ? Answer{{}, false} : m_judge(name());
    m_remark->setText(answer.remark);
    m_keep->setEnabled(answer.allowed);
}

} // namespace sparkout
