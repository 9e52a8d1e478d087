// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/name_dialog.h"

#include "ui/kit/answer_buttons.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"

#include <QFormLayout>
#include <QLineEdit>

#include <utility>

namespace sparkout {

NameDialog::NameDialog(const QString& name, std::function<bool(const QString&)> isFree,
                       QWidget* parent)
    : QDialog(parent), m_name(new QLineEdit(name, this)) {
    setWindowTitle(tr("Rename the surface"));
    setHelpTopic(*this, QStringLiteral("surfaces"));
    m_name->setObjectName(QStringLiteral("surfaceName"));
    m_name->setAccessibleName(tr("Name"));
    m_name->selectAll();
    setTextMinimumWidth(*m_name, 260);
    auto* buttons = new AnswerButtons(tr("&Rename"), tr("&Cancel"), this);
    auto* take = buttons->acceptButton();
    connect(m_name, &QLineEdit::textChanged, take,
            [take, isFree = std::move(isFree)](const QString& text) {
                take->setEnabled(isFree(text));
                take->setToolTip(take->isEnabled() ? QString()
                                                   : tr("Each surface has a name of its own."));
            });
    auto* form = new QFormLayout(this);
    form->addRow(tr("Name"), m_name);
    form->addRow(buttons);
}

QString NameDialog::name() const {
    return m_name->text().simplified();
}

} // namespace sparkout
