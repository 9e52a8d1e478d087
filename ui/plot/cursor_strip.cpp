// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_strip.h"

#include "ui/dialogs/copy_table.h"
#include "ui/fields/mark.h"
#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/plot/plot_cursors.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// A, B and B − A.
void put(std::vector<std::optional<double>>& into, std::size_t group,
         const std::optional<double>& a, const std::optional<double>& b) {
    into[3 * group] = a;
    into[3 * group + 1] = b;
    into[3 * group + 2] = a && b ? std::optional(*b - *a) : std::nullopt;
}

} // namespace

void CursorModel::show(const QString& axis, const Places& places, const ReadCurves& curves) {
    QStringList groups;
    for (const ReadCurve& curve : curves) {
        if (!groups.contains(curve.group)) {
            groups << curve.group;
        }
    }
    if (groups.isEmpty()) {
        groups << QString();
    }
    const auto width = static_cast<std::size_t>(groups.size()) * perGroup;
    std::vector<Row> rows{{axis, Digits::significant, true, {}}};
    rows.front().values.resize(width);
    for (std::size_t group = 0; group < width / perGroup; ++group) {
        put(rows.front().values, group, places[0], places[1]);
    }
    for (const ReadCurve& curve : curves) {
        auto row = std::ranges::find(rows, curve.name, &Row::name);
        if (row == rows.end()) {
            row = rows.insert(rows.end(), {curve.name, curve.digits, false, {}});
            row->values.resize(width);
        }
        const auto value = [&](const std::optional<double>& place) {
            return place ? curve.at(*place) : std::nullopt;
        };
        put(row->values, static_cast<std::size_t>(groups.indexOf(curve.group)), value(places[0]),
            value(places[1]));
    }
    const bool same = groups == m_groups && rows.size() == m_rows.size();
    if (same) {
        m_rows = std::move(rows);
        cellsChanged();
        return;
    }
    beginResetModel();
    m_groups = std::move(groups);
    m_rows = std::move(rows);
    endResetModel();
}

QString CursorModel::valueText(const Row& row, int column) const {
    const std::optional<double>& value = row.values[static_cast<std::size_t>(column)];
    if (!value) {
        return QStringLiteral("–");
    }
    const bool difference = column % perGroup == perGroup - 1;
    if (row.place) {
        return statedPlace(*value);
    }
    if (!difference) {
        return stated(*value, row.digits);
    }
    const std::optional<double>& beside = row.values[static_cast<std::size_t>(column) - 1];
    return statedDifference(*value, row.digits, beside.value_or(*value));
}

QVariant CursorModel::cell(int line, int column, int role) const {
    const Row& row = m_rows[static_cast<std::size_t>(line) + 1]; // row 0 has the places
    if (role == Qt::DisplayRole) {
        return column == 0 ? row.name : valueText(row, column - 1);
    }
    return role == Qt::TextAlignmentRole && column > 0 ? aligned(true) : QVariant();
}

QString CursorModel::header(int section, QChar between) const {
    if (section == 0) {
        return tr("Curve");
    }
    const QString& group = m_groups[(section - 1) / perGroup];
    const int which = (section - 1) % perGroup;
    const QString place = which == 0   ? QStringLiteral("A")
                          : which == 1 ? QStringLiteral("B")
                                       : QStringLiteral("B − A");
    return group.isEmpty() ? place : group + between + place;
}

QVariant CursorModel::head(int column, int role) const {
    const bool known = column >= 0 && column < columnsShown();
    return known && role == Qt::DisplayRole ? header(column, u'\n') : QVariant();
}

CsvTable CursorModel::table() const {
    CsvTable table;
    for (int section = 0; section < columnCount(); ++section) {
        table.header << header(section, u' ');
    }
    for (const Row& row : m_rows) {
        std::vector<CsvCell> cells{row.name};
        for (const std::optional<double>& value : row.values) {
            CsvCell& cell = cells.emplace_back();
            if (value) {
                cell.emplace<double>(row.place ? plainPlace(*value) : *value);
            }
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

QString CursorModel::asTsv() const {
    return tabSeparated(table(), QLocale());
}

namespace {

constexpr int mostRows = 8, leastRows = 1; ///< visible

/// A table as high as its rows, up to a limit; then it scrolls.
class ReadingTable : public CopyTable {
public:
    using CopyTable::CopyTable;
    [[nodiscard]] QSize sizeHint() const override { return {200, heightOf(mostRows)}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, heightOf(leastRows)}; }

private:
    [[nodiscard]] int heightOf(int most) const {
        const int rows = model() ? std::min(model()->rowCount(), most) : 0;
        int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
        for (int row = 0; row < rows; ++row) {
            height += rowHeight(row);
        }
        const bool wide = horizontalHeader()->length() > viewport()->width();
        return height + (wide ? horizontalScrollBar()->sizeHint().height() : 0);
    }
};

} // namespace

CursorStrip::CursorStrip(PlotCursors& cursors, QWidget* parent)
    : QWidget(parent)
    , m_cursors(cursors)
    , m_axis(new QLabel(this))
    , m_difference(new QLabel(this))
    , m_reason(new ReasonLabel(this))
    , m_model(new CursorModel(this))
    , m_table(new ReadingTable([this] { return m_model->asTsv(); }, this)) {
    setObjectName(QStringLiteral("cursorStrip"));
    build();
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &CursorStrip::fill);
    connect(&cursors, &PlotCursors::moved, this, &CursorStrip::follow);
    connect(&cursors.plot(), &QCustomPlot::afterReplot, this, &CursorStrip::follow);
    connect(&cursors, &PlotCursors::shownChanged, this, [this] {
        setVisible(m_cursors.shown());
        follow();
    });
    retranslate();
    hide();
}

void CursorStrip::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::tight);
    m_axis->setTextFormat(Qt::PlainText);
    row->addWidget(m_axis);
    for (std::size_t cursor = 0; cursor < PlotCursors::count; ++cursor) {
        m_letters[cursor] = new QLabel(PlotCursors::letter(cursor), this);
        auto* field = m_fields[cursor] = new NumberField({}, this);
        field->setObjectName(QStringLiteral("cursor") + PlotCursors::letter(cursor));
        setTextWidth(*field, metrics::field);
        m_letters[cursor]->setBuddy(field);
        row->addSpacing(metrics::gap);
        row->addWidget(m_letters[cursor]);
        row->addWidget(field);
        connect(field, &NumberField::valueEdited, this, [this, cursor, field] {
            if (const auto value = field->value()) {
                m_cursors.moveTo(cursor, *value);
            }
        });
        connect(field, &NumberField::remarkChanged, this, &CursorStrip::showReason);
    }
    m_difference->setObjectName(QStringLiteral("cursorDifference"));
    m_difference->setTextFormat(Qt::PlainText);
    m_difference->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addSpacing(metrics::gap);
    row->addWidget(m_difference, 1);
    column->addLayout(row);
    column->addWidget(m_reason);
    column->addWidget(m_table, 1);
    m_table->setObjectName(QStringLiteral("cursorTable"));
    m_table->setModel(m_model);
    m_table->setWordWrap(false);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(10);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void CursorStrip::follow() {
    if (m_cursors.shown() && !m_later.isActive()) {
        m_later.start();
    }
}

void CursorStrip::fill() {
    if (!m_cursors.shown()) {
        return;
    }
    const CursorSubject& subject = m_cursors.subject();
    const QCPRange span = subject.span();
    NumberSpec spec;
    spec.hard = {plainPlace(span.lower), plainPlace(span.upper)};
    CursorModel::Places places;
    for (std::size_t cursor = 0; cursor < PlotCursors::count; ++cursor) {
        places[cursor] = m_cursors.at(cursor);
        NumberField& field = *m_fields[cursor];
        field.setSpec(spec);
        const auto typed = field.value();
        const double near = 1e-9 * std::max(std::abs(places[cursor].value_or(0)), span.size());
        if (places[cursor] && (!typed || std::abs(*typed - *places[cursor]) > near)) {
            field.setValue(plainPlace(*places[cursor]));
        }
    }
    const int before = m_table->sizeHint().height();
    m_axis->setText(subject.axis());
    const bool both = places[0] && places[1];
    m_difference->setToolTip(both ? tr("B − A = %1").arg(statedPlace(*places[1] - *places[0]))
                                  : QString());
    showDifference();
    m_model->show(subject.axis(), places, subject.curves());
    if (m_table->sizeHint().height() != before) {
        m_table->updateGeometry();
    }
}

/// Shows as much as fits; the tool tip has the complete text.
void CursorStrip::showDifference() {
    const QString text = m_difference->toolTip();
    m_difference->setText(
        m_difference->fontMetrics().elidedText(text, Qt::ElideRight, m_difference->width()));
    m_difference->setAccessibleDescription(text);
}

void CursorStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate(); // the label has its width
    showDifference();
}

/// Shows the reason of the first marked field.
void CursorStrip::showReason() {
    for (const std::size_t cursor : {std::size_t{0}, std::size_t{1}}) {
        Remark remark = m_fields[cursor]->remark();
        if (remark.mark != Mark::none) {
            remark.reason =
                QStringLiteral("%1: %2").arg(PlotCursors::letter(cursor), remark.reason);
            m_reason->showRemark(remark);
            return;
        }
    }
    m_reason->showRemark({});
}

void CursorStrip::retranslate() {
    setAccessibleName(tr("Cursors"));
    m_table->setAccessibleName(tr("Values at the cursors and their differences"));
    m_table->retranslate();
    m_cursors.retranslate();
    m_difference->setAccessibleName(tr("Difference of the places"));
    for (std::size_t cursor = 0; cursor < PlotCursors::count; ++cursor) {
        m_fields[cursor]->setAccessibleName(
            tr("Place of cursor %1").arg(PlotCursors::letter(cursor)));
        m_fields[cursor]->retranslate();
    }
    follow();
}

} // namespace sparkout
