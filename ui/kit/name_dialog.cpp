// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/name_dialog.h"

#include "ui/kit/dialog_parts.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int longestNewName = 200;
constexpr int nameDialogWidth = 420; ///< [px]

} // namespace

NameDialog::NameDialog(const QString& title, const QString& accept, const QString& name,
                       Judge judge, QWidget* parent)
    : QDialog(parent)
    , m_judge(std::move(judge))
    , m_name(new QLineEdit(this))
    , m_remark(plainLabel({}, this)) {
    setWindowTitle(title);
    m_name->setObjectName(QStringLiteral("newName"));
    m_name->setAccessibleName(tr("Name"));
    m_name->setMaxLength(std::max(longestNewName, static_cast<int>(name.size())));
    m_name->setText(name);
    m_name->selectAll();
    m_remark->setAccessibleName(tr("Action"));
    m_remark->setMinimumHeight(m_remark->fontMetrics().lineSpacing() * 2);
    m_remark->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new AnswerButtons(accept, tr("&Cancel"), this);
    m_accept = buttons->acceptButton();
    m_accept->setObjectName(QStringLiteral("acceptName"));
    connect(m_name, &QLineEdit::textChanged, this, &NameDialog::follow);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Name"), m_name);
    form->addRow(m_remark);
    form->addRow(buttons);
    resize(nameDialogWidth, sizeHint().height());
    follow();
}

QString NameDialog::name() const {
    return m_name->text().simplified();
}

void NameDialog::follow() {
    const Answer answer = name().isEmpty() ? Answer{{}, false} : m_judge(name());
    m_remark->setText(answer.remark);
    m_accept->setEnabled(answer.allowed);
}

} // namespace sparkout
