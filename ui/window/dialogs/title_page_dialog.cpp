// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/title_page_dialog.h"

#include "ui/form/struct_form.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/session/settings.h"

#include <QLabel>
#include <QVBoxLayout>

namespace sparkout {

namespace {

constexpr int titlePageWidth = 640;

} // namespace

TitlePageDialog::TitlePageDialog(Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_page(report::Institution::fromKept(settings.titlePage())) {
    setWindowTitle(tr("Title page of laboratory reports"));
    setHelpTopic(*this, QStringLiteral("reports#course"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(plainLabel(tr("Printed on the title pages of the reports on laboratory "
                                    "works. All of it may be empty."),
                                 this));
    layout->addWidget(StructForm::over(m_page, this));
    auto* buttons = new AnswerButtons(tr("&Keep"), tr("Cance&l"), this);
    buttons->acceptButton()->setObjectName(QStringLiteral("keepTitlePage"));
    layout->addWidget(buttons);
    resize(atFontSize(titlePageWidth), sizeHint().height());
}

void TitlePageDialog::accept() {
    m_settings.setTitlePage(m_page.kept());
    QDialog::accept();
}

} // namespace sparkout
