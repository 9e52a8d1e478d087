// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/calibration_dialog.h"

#include "core/identification/fit_data.h"
#include "core/measured/calibrated_inputs.h"
#include "core/project/measured.h"
#include "ui/identification/cycle_fit_page.h"
#include "ui/identification/stiffness_page.h"
#include "ui/identification/trial_page.h"
#include "ui/identification/wheel_page.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/text/texts.h"

#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <QVBoxLayout>

namespace sparkout {

namespace {

constexpr EditText takenText{"Edit", QT_TRANSLATE_NOOP("Edit", "Calibrate from measurements")};

/// The records that are new or of another value.
std::vector<Calibration> newRecords(const Project& before, const Project& after) {
    std::vector<Calibration> records;
    for (const Calibration& record : after.measured->calibrations) {
        const Calibration* const old = calibrationOf(before, record.input);
        if (!old || old->value != record.value || old->data != record.data
            || old->date != record.date || old->count != record.count) {
            records.push_back(record);
        }
    }
    return records;
}

} // namespace

CalibrationDialog::CalibrationDialog(const Project& project, QWidget* parent)
    : QDialog(parent), m_project(project), m_taken(project) {
    setWindowTitle(tr("Calibrate from measurements"));
    setObjectName(QStringLiteral("calibration"));
    setHelpTopic(*this, QStringLiteral("calibration"));
    auto* tabs = new QTabWidget(this);
    tabs->setObjectName(QStringLiteral("calibrationTabs"));
    QWidget* cycle = nullptr;
    if (isEmpty()) {
        cycle = emptyPage();
    } else {
        auto* const page = new CycleFitPage(m_project, tabs);
        connect(page, &CycleFitPage::taken, this, &CalibrationDialog::take);
        cycle = page;
    }
    tabs->addTab(cycle, tr("Cycle"));
    auto* wheel = new WheelPage(m_project, tabs);
    connect(wheel, &WheelPage::taken, this, &CalibrationDialog::take);
    tabs->addTab(wheel, tr("Ra and strengths"));
    auto* stiffness = new StiffnessPage(m_project, tabs);
    connect(stiffness, &StiffnessPage::taken, this, &CalibrationDialog::take);
    tabs->addTab(stiffness, tr("Stiffness trial"));
    tabs->addTab(new TrialPage(m_project, tabs), tr("Which trial"));
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* const close = buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
    close->setAutoDefault(false);
    close->setObjectName(QStringLiteral("calibrationClose"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs, 1);
    column->addWidget(buttons);
    const QSize room = parent ? parent->window()->size() : screen()->availableSize();
    resize(QSize(atFontSize(1020), atFontSize(620)).boundedTo(room));
}

bool CalibrationDialog::isEmpty() const {
    const FitData all = fitDataOf(m_project, {}, true);
    return all.groups.empty() && all.withoutFactor.empty();
}

QWidget* CalibrationDialog::emptyPage() {
    auto* page = new QWidget(this);
    auto* words = new QLabel(
        tr("There is nothing yet that the cycle could be fitted to: no recorded trace, no "
           "diameters of finished parts.\n\n"
           "Import measurements… reads them from tables: the size at the gauge, the power of the "
           "wheel, the current of its spindle or the normal force over the time of one cycle, or "
           "the diameters of finished parts by zone or section.\n\n"
           "The size alone gives α and β, that is the compliance with the force together; the "
           "power adds its two shares; with the normal force compliance, flow stress and dullness "
           "are told apart."),
        page);
    words->setObjectName(QStringLiteral("calibrationEmpty"));
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(metrics::wide, metrics::wide, metrics::wide, metrics::wide);
    column->addWidget(words);
    column->addStretch(1);
    return page;
}

void CalibrationDialog::take(const Project& calibrated) {
    m_taken = calibrated;
    accept();
}

QString CalibrationDialog::calibrate(Document& document, QWidget* window) {
    CalibrationDialog dialog(document.project(), window);
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    const std::vector<Calibration> records = newRecords(document.project(), dialog.project());
    document.endMerge();
    document.edit(dialog.project(), takenText);
    QStringList names;
    for (const Calibration& record : records) {
        names << inputLocation(record.input);
    }
    return names.isEmpty()
               ? QString()
               : tr("Calibrated: %1. Undo reverts it.").arg(names.join(QStringLiteral("; ")));
}

} // namespace sparkout
