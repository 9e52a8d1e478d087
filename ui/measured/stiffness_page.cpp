// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/stiffness_page.h"

#include "core/measured/number_table.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/units.h"
#include "ui/form/mark.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/metrics.h"
#include "ui/measured/fit_words.h"
#include "ui/measured/stiffness_sheet.h"
#include "ui/table/pasted_cells.h"
#include "ui/table/value_table.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDate>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPalette>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

/// The readings of a stiffness trial, typed or pasted: place, load and deflection. A row without a
/// deflection has not been read yet; an empty row follows the last one.
class StiffnessModel : public TableModel {
    Q_DECLARE_TR_FUNCTIONS(sparkout::StiffnessModel)

public:
    enum Column { place, load, deflection, columns };

    /// The rows of the sheet: each place at half the load and at the load, twice.
    StiffnessModel(const std::vector<double>& places_mm, double load_n, QObject* parent = nullptr);

    void setEdited(std::function<void()> edited) { m_edited = std::move(edited); } ///< by hand

    [[nodiscard]] std::vector<StiffnessReading> readings() const; ///< the complete ones
    /// The fault of the first invalid row; empty if there is none.
    [[nodiscard]] QString fault() const;

    void paste(const QModelIndex& from, const PastedCells& cells);
    void clear(const QModelIndexList& cells);

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    using Row = std::array<QString, columns>;

    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return columns; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] static QString faultOf(const Row& row, int column);
    void put(int row, int column, const QString& text);
    void follow(); ///< adds an empty row at the end

    std::vector<Row> m_rows;
    std::function<void()> m_edited = [] {};
};

namespace {

constexpr std::size_t mostReadings = 1000;

bool isEmptyRow(const std::array<QString, StiffnessModel::columns>& row) {
    return std::ranges::all_of(row, &QString::isEmpty);
}

} // namespace

StiffnessModel::StiffnessModel(const std::vector<double>& places_mm, double load_n, QObject* parent)
    : TableModel(parent) {
    const QLocale locale;
    constexpr int times = 2;
    for (const double place_mm : places_mm) {
        for (int i = 0; i < times; ++i) {
            for (const double force_n : {load_n / 2, load_n}) {
                m_rows.push_back({showNumber(place_mm, locale), showNumber(force_n, locale), {}});
            }
        }
    }
    m_rows.emplace_back();
}

std::vector<StiffnessReading> StiffnessModel::readings() const {
    std::vector<StiffnessReading> list;
    for (const Row& row : m_rows) {
        const auto at = pastedNumber(row[place]), force = pastedNumber(row[load]),
                   read = pastedNumber(row[deflection]);
        if (at && force && *force > 0 && read) {
            list.push_back({*at, *force, *read});
        }
    }
    return list;
}

QString StiffnessModel::faultOf(const Row& row, int column) {
    const QString& text = row.at(static_cast<std::size_t>(column));
    const auto number = pastedNumber(text);
    if (!text.isEmpty() && !number) {
        return tr("“%1” is not a number.").arg(printableText(text));
    }
    const bool isRead = !row[deflection].isEmpty();
    if (column == place && isRead && text.isEmpty()) {
        return tr("The place is missing.");
    }
    if (column == load && isRead && (!number || *number <= 0)) {
        return tr("The load must be above 0 N.");
    }
    return {};
}

QString StiffnessModel::fault() const {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        for (int column = 0; column < columns; ++column) {
            if (const QString text = faultOf(m_rows[i], column); !text.isEmpty()) {
                return tr("Row %1: %2").arg(i + 1).arg(text);
            }
        }
    }
    return {};
}

void StiffnessModel::put(int row, int column, const QString& text) {
    const auto at = static_cast<std::size_t>(row);
    if (column >= columns || at >= mostReadings) {
        return;
    }
    if (at >= m_rows.size()) {
        m_rows.resize(at + 1);
    }
    m_rows[at].at(static_cast<std::size_t>(column)) = text.trimmed();
}

void StiffnessModel::follow() {
    if (m_rows.empty() || !isEmptyRow(m_rows.back())) {
        m_rows.emplace_back();
    }
}

void StiffnessModel::paste(const QModelIndex& from, const PastedCells& cells) {
    beginResetModel();
    for (std::size_t i = 0; i < cells.rows.size(); ++i) {
        for (qsizetype k = 0; k < cells.rows[i].size(); ++k) {
            put(std::max(from.row(), 0) + static_cast<int>(i),
                std::max(from.column(), 0) + static_cast<int>(k), cells.rows[i][k]);
        }
    }
    follow();
    endResetModel();
    m_edited();
}

void StiffnessModel::clear(const QModelIndexList& cells) {
    for (const QModelIndex& one : cells) {
        put(one.row(), one.column(), {});
    }
    cellsChanged();
    m_edited();
}

Qt::ItemFlags StiffnessModel::flags(const QModelIndex& index) const {
    return TableModel::flags(index) | Qt::ItemIsEditable;
}

bool StiffnessModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole) {
        return false;
    }
    put(index.row(), index.column(), value.toString());
    cellsChanged(); // faults of a row are shown in its other cells
    if (!isEmptyRow(m_rows.back())) {
        beginInsertRows({}, rowsShown(), rowsShown());
        m_rows.emplace_back();
        endInsertRows();
    }
    m_edited();
    return true;
}

QVariant StiffnessModel::cell(int row, int column, int role) const {
    const Row& shown = m_rows.at(static_cast<std::size_t>(row));
    const QString fault = faultOf(shown, column);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return shown.at(static_cast<std::size_t>(column));
    case Qt::ToolTipRole: return fault.isEmpty() ? QVariant() : fault;
    case Qt::AccessibleTextRole:
        return tr("%1, row %2").arg(head(column, Qt::DisplayRole).toString()).arg(row + 1);
    case Qt::ForegroundRole:
        return fault.isEmpty() ? QVariant()
                               : QVariant(markColor(Mark::error, QGuiApplication::palette()));
    case Qt::TextAlignmentRole: return aligned(true);
    default: return {};
    }
}

QVariant StiffnessModel::head(int column, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case place: return tr("Place, mm");
    case load: return tr("Load, N");
    default: return tr("Deflection, µm");
    }
}

QVariant StiffnessModel::side(int row, int role) const {
    return role == Qt::DisplayRole ? QVariant(row + 1) : QVariant();
}

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
    m_model->setEdited([this] { evaluate(); });
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
    m_take->setToolTip(tr("Applies the stiffness found to the machine, as one edit that can be "
                          "undone, and marks it as calibrated; γ then follows from it"));
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
        m_words->setText(tr("The trial needs an external surface and a shaft without steady rests, "
                            "whose steps are given on the page Part of the inputs: its bending is "
                            "computed and subtracted from the readings."));
    } else if (!m_isComplete) {
        m_words->setText(tr("Inputs of the project are missing or wrong: first correct the faults "
                            "in the messages."));
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
