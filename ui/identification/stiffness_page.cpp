// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/stiffness_page.h"

#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/units.h"
#include "ui/identification/fit_table.h"
#include "ui/identification/fit_words.h"
#include "ui/identification/stiffness_model.h"
#include "ui/identification/stiffness_sheet.h"
#include "ui/kit/copyable_label.h"
#include "ui/kit/metrics.h"
#include "ui/text/names.h"
#include "words/trial_words.h"

#include <QClipboard>
#include <QComboBox>
#include <QDate>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

QScrollArea* scrolledColumn(QWidget* content, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->viewport()->setAutoFillBackground(false); // the page's own background is visible
    content->setAutoFillBackground(false);
    return area;
}

/// Whether there is no error, except that the compliance is missing, which the trial determines.
bool isSoundBut(const Project& project, bool withCompliance) {
    return std::ranges::none_of(validate(project), [withCompliance](const Issue& issue) {
        return issue.severity == Severity::error
               && (withCompliance || issue.code != IssueCode::complianceMissing);
    });
}

bool canBeLoaded(const Part& part) {
    return part.surface == Surface::external && !part.shaft.segments.empty()
           && part.shaft.steady_rests.empty();
}

double loadOf(const Project& project) {
    constexpr double usual_n = 100;
    return isSoundBut(project, true) ? stiffnessLoad_n(project) : usual_n;
}

} // namespace

StiffnessPage::StiffnessPage(const Project& project, QWidget* parent)
    : QWidget(parent)
    , m_project(project)
    , m_table(new QTableView(this))
    , m_indicator(new QComboBox(this))
    , m_words(copyableLabel(this))
    , m_found(new FitTable(tr("Stiffness found"), this))
    , m_compliance(new FitTable(tr("Compliance along the part"), this))
    , m_take(new QPushButton(tr("&Apply the stiffness"), this))
    , m_isMeasurable(canBeLoaded(*project.part))
    , m_isComplete(isSoundBut(project, false)) {
    std::vector<double> places;
    if (m_isMeasurable) {
        for (const double place : stiffnessPlaces_mm(project)) {
            places.push_back(std::round(place));
        }
    }
    const double load = loadOf(project);
    m_sheet = std::make_unique<StiffnessSheet>(project, places, load);
    m_model = new StiffnessModel(places, load, this);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::wide);
    row->addWidget(buildSheet(), 3);
    row->addWidget(buildReadings(), 2);
    row->addWidget(buildResult(), 3);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    connect(m_model, &StiffnessModel::edited, this, &StiffnessPage::evaluate);
    connect(m_indicator, &QComboBox::currentIndexChanged, this, &StiffnessPage::evaluate);
    connect(m_take, &QPushButton::clicked, this, [this] { emit taken(calibrated()); });
    evaluate();
}

StiffnessPage::~StiffnessPage() = default;

QWidget* StiffnessPage::buildSheet() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    auto* steps = copyableLabel(page);
    steps->setObjectName(QStringLiteral("stiffnessSteps"));
    QStringList lines;
    for (const QString& step : m_isMeasurable ? m_sheet->steps() : QStringList()) {
        lines << QStringLiteral("%1. %2").arg(lines.size() + 1).arg(step);
    }
    steps->setText(lines.join(QStringLiteral("\n\n")));
    steps->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* print = new QPushButton(tr("&Print the sheet…"), page);
    print->setObjectName(QStringLiteral("stiffnessPrint"));
    print->setToolTip(tr("These steps and a table to write the readings into, on one page"));
    column->addWidget(scrolledColumn(steps, page), 1);
    print->setEnabled(m_isMeasurable);
    column->addWidget(print, 0, Qt::AlignLeft);
    connect(print, &QPushButton::clicked, this, [this] { m_sheet->print(this); });
    return page;
}

QWidget* StiffnessPage::buildReadings() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_indicator->setObjectName(QStringLiteral("stiffnessIndicator"));
    m_indicator->addItem(tr("on the bed"), static_cast<int>(DeflectionOf::part));
    m_indicator->addItem(tr("on the wheel head"), static_cast<int>(DeflectionOf::system));
    auto* label = new QLabel(tr("&Indicator:"), page);
    label->setBuddy(m_indicator);
    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(m_indicator, 1);
    m_table->setObjectName(QStringLiteral("stiffnessReadings"));
    m_table->setAccessibleName(tr("Readings of the trial"));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::ContiguousSelection);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                             | QAbstractItemView::AnyKeyPressed);
    QHeaderView* const heads = m_table->horizontalHeader();
    heads->setSectionResizeMode(QHeaderView::Stretch);
    int widest = 0; // the same for all
    for (int section = 0; section < m_model->columnCount(); ++section) {
        widest = std::max(widest, heads->sectionSizeHint(section));
    }
    m_table->setMinimumWidth(
        m_model->columnCount() * widest + m_table->verticalHeader()->sizeHint().width()
        + 2 * m_table->frameWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height()
                                                     + 2 * metrics::tight);
    m_table->setToolTip(tr("Type the deflections, or paste a table of place, load and deflection "
                           "with Ctrl+V"));
    m_table->installEventFilter(this);
    m_table->setCurrentIndex(m_model->index(0, StiffnessModel::deflection));
    m_table->setEnabled(m_isMeasurable);
    column->addLayout(line);
    column->addWidget(m_table, 1);
    return page;
}

QWidget* StiffnessPage::buildResult() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_words->setObjectName(QStringLiteral("stiffnessWords"));
    m_found->setObjectName(QStringLiteral("stiffnessFound"));
    m_compliance->setObjectName(QStringLiteral("stiffnessCompliance"));
    m_take->setObjectName(QStringLiteral("stiffnessTake"));
    m_take->setToolTip(tr("Gives the machine the stiffness found, as one edit that can be undone, "
                          "marks it as calibrated, and lets γ follow from it"));
    auto* shown = new QWidget(page);
    auto* lines = new QVBoxLayout(shown);
    lines->setContentsMargins(0, 0, metrics::gap, 0);
    lines->addWidget(m_words);
    lines->addWidget(m_found);
    lines->addWidget(m_compliance);
    lines->addStretch(1);
    column->addWidget(scrolledColumn(shown, page), 1);
    column->addWidget(m_take, 0, Qt::AlignRight);
    return page;
}

bool StiffnessPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_table || event->type() != QEvent::KeyPress) {
        return QWidget::eventFilter(watched, event);
    }
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Paste)) {
        const QModelIndex from = m_table->currentIndex();
        const int row = from.row(), column = from.column();
        m_model->paste(from, PastedCells::of(QGuiApplication::clipboard()->mimeData()));
        m_table->setCurrentIndex(m_model->index(row, column));
        return true;
    }
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) { // moves to the next reading
        const QModelIndex at = m_table->currentIndex();
        m_table->setCurrentIndex(m_model->index(std::min(at.row() + 1, m_model->rowCount() - 1),
                                                std::max(at.column(), 0)));
        return true;
    }
    if (key->key() == Qt::Key_Delete || key->key() == Qt::Key_Backspace) {
        m_model->clear(m_table->selectionModel()->selectedIndexes());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

StiffnessRequest StiffnessPage::request() const {
    StiffnessRequest request;
    request.readings = m_model->readings();
    request.deflection = static_cast<DeflectionOf>(m_indicator->currentData().toInt());
    std::set<double> places;
    for (const StiffnessReading& reading : request.readings) {
        places.insert(reading.position_mm);
    }
    constexpr std::size_t enoughForWheelHead = 3;
    request.findWheelHead =
        request.deflection == DeflectionOf::system && places.size() >= enoughForWheelHead;
    return request;
}

void StiffnessPage::evaluate() {
    const StiffnessRequest asked = request();
    const QString fault = m_model->fault();
    m_trial = {};
    m_found->hide();
    m_compliance->hide();
    m_take->setEnabled(false);
    if (!m_isMeasurable) {
        m_words->setText(tr("The trial is of an external surface and of a shaft without steady "
                            "rests, whose steps are given on the page Part of the inputs: its "
                            "bending, which is computed, is taken off the readings."));
    } else if (!m_isComplete) {
        m_words->setText(tr(
            "Inputs of the project are missing or wrong: first correct what the messages name."));
    } else if (!fault.isEmpty()) {
        m_words->setText(fault);
    } else if (asked.readings.empty()) {
        m_words->setText(tr("Enter the deflections: the result is shown here at once."));
    } else {
        m_trial = stiffnessFromTrial(m_project, asked);
        showFound();
    }
}

Project StiffnessPage::calibrated() const {
    const StiffnessRequest asked = request();
    std::set<double> places;
    for (const StiffnessReading& reading : asked.readings) {
        places.insert(reading.position_mm);
    }
    const auto count = static_cast<int>(places.size());
    StiffnessTrial rounded = m_trial; // limits the digits to those of the readings
    constexpr int digits = 4;
    for (FoundStiffness& found : rounded.found) {
        found.n_um = QString::number(found.n_um, 'g', digits).toDouble();
    }
    return withStiffness(
        m_project, rounded, tr("stiffness trial at %n place(s)", nullptr, count).toStdString(),
        QDate::currentDate().toString(Qt::ISODate).toStdString(), asked.readings.size());
}

void StiffnessPage::showFound() {
    if (m_trial.status != StiffnessTrialStatus::found) {
        QStringList units;
        for (const StiffnessUnit unit : m_trial.negative) {
            units << FitWords::trial(wordsOf(unit));
        }
        const QString words = FitWords::trial(wordsOf(m_trial.status));
        m_words->setText(units.isEmpty() ? tr("Nothing can be found: %1.").arg(words)
                                         : tr("Nothing can be found: %1 (%2).")
                                               .arg(words, units.join(QStringLiteral(", "))));
        return;
    }
    const Project after = calibrated();
    const auto& before = m_project.machine->stiffness_n_um;
    std::vector<QStringList> rows;
    for (int i = 0; i < static_cast<int>(StiffnessUnit::count_); ++i) {
        const auto unit = static_cast<StiffnessUnit>(i);
        const auto found = std::ranges::find(m_trial.found, unit, &FoundStiffness::unit);
        const bool isFound = found != m_trial.found.end();
        const QString dash = QStringLiteral("—");
        rows.push_back(
            {FitWords::trial(wordsOf(unit)),
             before ? FitWords::number((*before).*memberOf(unit)) : dash,
             isFound ? FitWords::number(found->n_um) : tr("not measured"),
             isFound && found->interval95 ? FitWords::interval(*found->interval95) : dash});
    }
    m_found->setCells({tr("Stiffness, N/µm"), tr("now"), tr("found"), tr("95 %")}, rows);
    m_found->show();
    QStringList words{tr("%n reading(s); those less what the stiffness gives: RMS %1 µm.", nullptr,
                         static_cast<int>(m_trial.residuals_um.size()))
                          .arg(FitWords::number(m_trial.rms_um))};
    if (m_trial.line != LoadLine::straight) {
        QStringList play;
        for (const double one_um : m_trial.play_um) {
            play << Names::micrometres(one_um);
        }
        const QString line = FitWords::trial(wordsOf(m_trial.line));
        words << (play.isEmpty() ? tr("Attention: %1.").arg(line)
                                 : tr("Attention: %1 (%2 µm).", "what is wrong, play of the units")
                                       .arg(line, play.join(QStringLiteral("; "))));
    }
    if (!before) {
        const QString wheelHead = FitWords::number(after.machine->stiffness_n_um->wheel_head);
        const bool isMeasured = std::ranges::any_of(m_trial.found, [](const FoundStiffness& one) {
            return one.unit == StiffnessUnit::wheel_head;
        });
        if (!isMeasured) {
            words << tr("The wheel head's stiffness is not known: %1 N/µm is put in, to be "
                        "measured with the indicator on the wheel head.")
                         .arg(wheelHead);
        }
    }
    if (!std::holds_alternative<std::monostate>(m_project.machine->compliance_mm_per_n)) {
        words << tr("The given compliance is removed; γ then follows from stiffness and shaft.");
    }
    m_words->setText(words.join(u'\n'));
    showCompliance(after);
    m_take->setEnabled(true);
}

/// γ(x) at the zones or sections before and after.
void StiffnessPage::showCompliance(const Project& after) {
    if (!isSoundBut(after, true)) {
        return;
    }
    const bool isKnown = isSoundBut(m_project, true);
    const std::vector<CompliantPoint> now =
        isKnown ? compliantPoints(m_project) : std::vector<CompliantPoint>();
    std::vector<QStringList> rows;
    const std::vector<CompliantPoint> then = compliantPoints(after);
    for (std::size_t i = 0; i < then.size(); ++i) {
        rows.push_back({FitWords::place(m_project, static_cast<int>(i)),
                        Names::fixed(then[i].position_mm, 1),
                        i < now.size() ? FitWords::number(now[i].gamma_mm_n) : QStringLiteral("—"),
                        FitWords::number(then[i].gamma_mm_n)});
    }
    m_compliance->setCells({tr("γ, mm/N"), tr("x, mm"), tr("now"), tr("then")}, rows);
    m_compliance->show();
}

} // namespace sparkout
