// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/company_dialog.h"

#include "core/file/safe_file.h"
#include "ui/form/struct_form.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/report/logo.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include <string>
#include <variant>

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

namespace {

constexpr int companyWidth = 560;
constexpr QSize logoShown(160, 40);

} // namespace

CompanyDialog::CompanyDialog(Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_company(settings.company())
    , m_logo(new QLabel(this))
    , m_fault(plainLabel({}, this))
    , m_remove(new QPushButton(tr("&Remove"), this)) {
    setWindowTitle(tr("Company and signatures"));
    setHelpTopic(*this, QStringLiteral("reports#company"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(plainLabel(
        tr("Printed in the heads of documents, in those of every project. All of it may be empty."),
        this));
    auto* logoRow = new QHBoxLayout;
    auto* choose = new QPushButton(tr("&Logo…"), this);
    choose->setObjectName(QStringLiteral("chooseLogo"));
    m_remove->setObjectName(QStringLiteral("removeLogo"));
    m_logo->setObjectName(QStringLiteral("logo"));
    m_logo->setAccessibleName(tr("Logo"));
    m_logo->setMinimumSize(logoShown);
    m_fault->setObjectName(QStringLiteral("logoFault"));
    logoRow->addWidget(choose);
    logoRow->addWidget(m_remove);
    logoRow->addWidget(m_logo, 1);
    layout->addWidget(StructForm::over<CompanyTexts>(m_company, this));
    layout->addLayout(logoRow);
    layout->addWidget(m_fault);
    connect(choose, &QPushButton::clicked, this, &CompanyDialog::chooseLogo);
    connect(m_remove, &QPushButton::clicked, this, [this] {
        m_company.logo.clear();
        showLogo({});
    });
    auto* buttons = new AnswerButtons(tr("&Keep"), tr("Cance&l"), this);
    buttons->acceptButton()->setObjectName(QStringLiteral("keepCompany"));
    layout->addWidget(buttons);
    showLogo(report::Logo::fault(m_company.logo));
    resize(companyWidth, sizeHint().height());
}

void CompanyDialog::chooseLogo() {
    const QString path = FileDialog::openPath(this, tr("Choose a logo"), m_settings.lastFolder(),
                                              tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty()) {
        takeLogo(path);
    }
}

void CompanyDialog::takeLogo(const QString& path) {
    const auto read = readFile(systemPath(path), static_cast<std::size_t>(report::Logo::mostBytes));
    if (const auto* error = std::get_if<FileError>(&read)) {
        showLogo(readErrorText(*error));
        return;
    }
    const auto bytes = QByteArray::fromStdString(std::get<std::string>(read));
    QString fault = report::Logo::fault(bytes);
    if (fault.isEmpty() && report::Logo::image(bytes).isNull()) {
        fault = report::Logo::damagedText();
    }
    if (!fault.isEmpty()) {
        showLogo(fault + u' ' + tr("The logo stays as it was."));
        return;
    }
    m_company.logo = bytes;
    showLogo({});
}

void CompanyDialog::showLogo(const QString& fault) {
    const QImage image = report::Logo::image(m_company.logo);
    m_logo->setText(image.isNull() ? tr("none") : QString());
    if (!image.isNull()) {
        m_logo->setPixmap(QPixmap::fromImage(
            image.scaled(logoShown, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    }
    m_remove->setEnabled(!m_company.logo.isEmpty());
    m_fault->setText(fault);
    m_fault->setVisible(!fault.isEmpty());
}

void CompanyDialog::accept() {
    m_settings.setCompany(m_company);
    QDialog::accept();
}

} // namespace sparkout
