// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/calibration_dialog.h"

#include "core/measured/calibrated_inputs.h"
#include "core/measured/fit_data.h"
#include "core/measured/wheel_calibration.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "ui/form/number_field.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/measured/cycle_fit_page.h"
#include "ui/measured/fit_words.h"
#include "ui/measured/stiffness_page.h"
#include "ui/measured/trial_page.h"
#include "ui/session/document.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDate>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// Calibrates the wheel by measured parts: its factor of Ra, and its strengths by one reading at
/// which it just began to shed its grains.
class WheelPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(sparkout::WheelPage)

public:
    using Taken = std::function<void(const Project&)>; ///< takes the project with the found values

    WheelPage(const Project& project, Taken taken, QWidget* parent);

private:
    QWidget* buildRoughness();
    QWidget* buildStrengths();
    void showStrengths();

    const Project& m_project;
    Taken m_taken;
    std::optional<RoughnessCalibration> m_roughness;
    std::optional<StrengthsCalibration> m_strengths;
    QComboBox* m_reading;
    NumberField* m_value;
    QLabel* m_unit;
    NumberField* m_width;
    QLabel* m_found;
    QPushButton* m_take;
};

std::string dateOfToday() {
    return QDate::currentDate().toString(Qt::ISODate).toStdString();
}

/// Why the inputs cannot take these values; empty if they can.
QString refusalOf(const Project& made) {
    Issues errors = validate(made);
    std::erase_if(errors, [](const Issue& issue) { return issue.severity != Severity::error; });
    return errors.empty() ? QString() : Names::refusal(errors, 1);
}

NumberField* positiveField(const char* unit, const char* name, QWidget* parent) {
    NumberSpec spec;
    spec.hard = {.low = 0, .lowOpen = true};
    spec.unit = unit;
    spec.optional = true;
    auto* field = new NumberField(spec, parent);
    field->setObjectName(QLatin1String(name));
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return field;
}

WheelPage::WheelPage(const Project& project, Taken taken, QWidget* parent)
    : QWidget(parent)
    , m_project(project)
    , m_taken(std::move(taken))
    , m_roughness(roughnessFromParts(project))
    , m_reading(new QComboBox(this))
    , m_value(positiveField("N", "limitValue", this))
    , m_unit(new QLabel(this))
    , m_width(positiveField("mm", "limitWidth", this))
    , m_found(copyableLabel(this))
    , m_take(new QPushButton(tr("Apply the s&trengths"), this)) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(buildRoughness());
    column->addWidget(buildStrengths());
    column->addStretch(1);
    showStrengths();
}

QWidget* WheelPage::buildRoughness() {
    auto* box = new QGroupBox(tr("Roughness Ra"), this);
    auto* column = new QVBoxLayout(box);
    auto* words = copyableLabel(box);
    words->setObjectName(QStringLiteral("roughnessFound"));
    auto* take = new QPushButton(tr("Apply the &Ra factor"), box);
    take->setObjectName(QStringLiteral("roughnessTake"));
    take->setEnabled(m_roughness.has_value());
    if (!m_roughness) {
        words->setText(tr("No Ra is measured, or the cycle does not end at size. Measured Ra is "
                          "imported with the parts: Import measurements…"));
    } else {
        QStringList lines{tr("Factor of Ra: %1, current %2 (n = %3).")
                              .arg(FitWords::number(m_roughness->factor),
                                   FitWords::number(m_project.wheel->roughness_factor))
                              .arg(m_roughness->count)};
        if (m_roughness->interval95) {
            lines << tr("95 % interval: %1.").arg(FitWords::interval(*m_roughness->interval95));
        }
        const QString wheel = printableText(QString::fromStdString(m_roughness->wheel));
        const QString dressing = printableText(QString::fromStdString(m_roughness->dressing));
        if (!wheel.isEmpty() || !dressing.isEmpty()) {
            lines << tr("It applies to this wheel and its dressing: %1")
                         .arg(QStringList{wheel, dressing}.join(QStringLiteral("; ")));
        } else {
            lines << tr("It applies to this wheel and its dressing.");
        }
        if (const QString refusal = refusalOf(withRoughness(m_project, *m_roughness, {}, {}));
            !refusal.isEmpty()) {
            lines << refusal;
            take->setEnabled(false);
        }
        words->setText(lines.join(u'\n'));
    }
    column->addWidget(words);
    column->addWidget(take, 0, Qt::AlignLeft);
    connect(take, &QPushButton::clicked, this, [this] {
        const auto count = static_cast<int>(m_roughness->count);
        m_taken(withRoughness(m_project, *m_roughness,
                              tr("measured Ra of %n part(s)", nullptr, count).toStdString(),
                              dateOfToday()));
    });
    return box;
}

QWidget* WheelPage::buildStrengths() {
    auto* box = new QGroupBox(tr("Strengths of the wheel"), this);
    auto* column = new QVBoxLayout(box);
    column->addWidget(
        copyableLabel(box, tr("One reading at which the wheel just began to shed its grains gives "
                              "a common factor of the four strengths of grain and bond.")));
    m_reading->setObjectName(QStringLiteral("limitReading"));
    m_reading->addItem(tr("normal force"), static_cast<int>(LimitReading::normal_force));
    m_reading->addItem(tr("power of the wheel, without idle power"),
                       static_cast<int>(LimitReading::wheel_power));
    m_width->setValue(std::min(m_project.wheel->width_mm, m_project.part->length_mm));
    m_found->setObjectName(QStringLiteral("strengthsFound"));
    m_take->setObjectName(QStringLiteral("strengthsTake"));
    const auto line = [](QWidget* field, QWidget* unit) {
        auto* row = new QHBoxLayout;
        row->addWidget(field);
        row->addWidget(unit);
        row->addStretch(1);
        return row;
    };
    auto* form = new QFormLayout;
    form->addRow(tr("Readin&g:"), m_reading);
    auto* valueLabel = new QLabel(tr("&Value at the limit:"), box);
    valueLabel->setBuddy(m_value);
    m_value->setAccessibleName(tr("Value at the limit"));
    form->addRow(valueLabel, line(m_value, m_unit));
    auto* widthLabel = new QLabel(tr("&Width of cut:"), box);
    widthLabel->setBuddy(m_width);
    m_width->setAccessibleName(tr("Width of cut, mm"));
    form->addRow(widthLabel, line(m_width, new QLabel(unitText("mm"), box)));
    column->addLayout(form);
    column->addWidget(m_found);
    column->addWidget(m_take, 0, Qt::AlignLeft);
    connect(m_reading, &QComboBox::currentIndexChanged, this, &WheelPage::showStrengths);
    for (const NumberField* field : {m_value, m_width}) {
        connect(field, &NumberField::valueEdited, this, &WheelPage::showStrengths);
        connect(field, &NumberField::remarkChanged, this, &WheelPage::showStrengths);
    }
    connect(m_take, &QPushButton::clicked, this, [this] {
        m_taken(withStrengths(m_project, *m_strengths,
                              tr("one reading at the limit, %1 %2")
                                  .arg(FitWords::number(*m_value->value()), m_unit->text())
                                  .toStdString(),
                              dateOfToday()));
    });
    return box;
}

void WheelPage::showStrengths() {
    const auto reading = static_cast<LimitReading>(m_reading->currentData().toInt());
    m_unit->setText(unitText(reading == LimitReading::normal_force ? "N" : "kW"));
    const bool isTyped =
        m_value->value() && m_width->value() && !m_value->refused() && !m_width->refused();
    m_strengths = isTyped
                      ? strengthsFromLimit(m_project, reading, *m_value->value(), *m_width->value())
                      : std::nullopt;
    const QString refusal =
        m_strengths ? refusalOf(withStrengths(m_project, *m_strengths, {}, {})) : QString();
    m_take->setEnabled(m_strengths && refusal.isEmpty());
    if (m_strengths) {
        const QString found = tr("Factor of the strengths: %1; depth of that cut: %2 µm.")
                                  .arg(FitWords::number(m_strengths->factor),
                                       FitWords::number(m_strengths->depth_mm * units::umPerMm));
        m_found->setText(refusal.isEmpty() ? found : found + u'\n' + refusal);
    } else {
        m_found->setText(isTyped ? tr("The strengths of grain and bond are not given: the page "
                                      "Wheel of the inputs has them.")
                                 : QString());
    }
}

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
    tabs->addTab(new WheelPage(
                     m_project, [this](const Project& calibrated) { take(calibrated); }, tabs),
                 tr("Ra and strengths"));
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
        tr("The project has no data to fit the cycle to: no recorded trace, no diameters of "
           "finished parts.\n\nImport measurements… reads them from tables: the size at the gauge, "
           "the power of the wheel, the current of its spindle or the normal force over the time "
           "of one cycle, or the diameters of finished parts by zone or section.\n\nThe size alone "
           "determines α and β, that is the compliance together with the force; the power adds its "
           "two shares; with the normal force compliance, flow stress and dullness are determined "
           "separately."),
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
