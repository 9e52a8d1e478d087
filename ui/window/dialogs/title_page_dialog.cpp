// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/title_page_dialog.h"

#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/report/course/institution.h"
#include "ui/session/settings.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace sparkout {

namespace {

constexpr int titlePageWidth = 640, longestTitleText = 300;

} // namespace

TitlePageDialog::TitlePageDialog(Settings& settings, QWidget* parent)
    : QDialog(parent), m_settings(settings) {
    setWindowTitle(tr("Title page of laboratory reports"));
    setHelpTopic(*this, QStringLiteral("reports#course"));
    auto* layout = new QVBoxLayout(this);
    auto* note = new QLabel(tr("Printed on the title pages of the reports on laboratory works. "
                               "All of it may be empty."),
                            this);
    note->setWordWrap(true);
    layout->addWidget(note);
    auto* form = new QFormLayout;
    const auto kept = report::Institution::fromKept(settings.titlePage());
    for (const report::InstitutionField& field : report::institutionFields()) {
        const QString label = QCoreApplication::translate("Institution", field.label);
        auto* edit = new QLineEdit(kept.*field.value, this);
        edit->setObjectName(QStringLiteral("title-") + QString::fromLatin1(field.key));
        edit->setAccessibleName(label);
        edit->setMaxLength(longestTitleText);
        form->addRow(label, edit);
        m_edits.push_back(edit);
    }
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(this);
    auto* keep = buttons->addButton(tr("&Keep"), QDialogButtonBox::AcceptRole);
    keep->setObjectName(QStringLiteral("keepTitlePage"));
    keep->setDefault(true);
    buttons->addButton(tr("Cance&l"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &TitlePageDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(atFontSize(titlePageWidth), sizeHint().height());
}

void TitlePageDialog::accept() {
    report::Institution made;
    for (std::size_t i = 0; i < m_edits.size(); ++i) {
        made.*report::institutionFields()[i].value = m_edits[i]->text();
    }
    m_settings.setTitlePage(made.kept());
    QDialog::accept();
}

} // namespace sparkout
