// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/plot_cursors.h"

#include "ui/dialogs/copy_table.h"
#include "ui/form/mark.h"
#include "ui/form/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double mouseReach = 5; ///< reach of the mouse, in pixels
constexpr double stepShare = 0.01;
constexpr double firstPlaces[] = {0.25, 0.75};
constexpr int tagPadding = 2;

QString cursorsLayer(QCustomPlot& plot) {
    const QString name = QStringLiteral("cursors");
    plot.addLayer(name);
    plot.layer(name)->setMode(QCPLayer::lmBuffered); // moving them redraws no curve
    return name;
}

/// The cursor moved by a key; empty for any other key.
std::optional<std::size_t> cursorOf(const QKeyEvent& event) {
    const bool arrow = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
    const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (arrow && modifiers == Qt::ShiftModifier) {
        return 0;
    }
    return arrow && modifiers == (Qt::ShiftModifier | Qt::ControlModifier)
               ? std::optional<std::size_t>(1)
               : std::nullopt;
}

} // namespace

PlotCursors::PlotCursors(QCustomPlot& plot, CursorSubject subject)
    : PaintedLayer(plot, cursorsLayer(plot), Edges::sharp)
    , toggle(new QAction(&plot))
    , m_subject(std::move(subject)) {
    toggle->setObjectName(QStringLiteral("cursors"));
    toggle->setCheckable(true);
    toggle->setIcon(themeIcon(u"cursors"));
    toggle->setShortcut(Qt::Key_C);
    toggle->setShortcutContext(Qt::WidgetShortcut);
    plot.addAction(toggle);
    plot.installEventFilter(this); // installed after the navigation, so called before it
    connect(toggle, &QAction::toggled, this, &PlotCursors::showThem);
    retranslate();
}

void PlotCursors::retranslate() {
    toggle->setText(tr("Cursors"));
    toggle->setToolTip(
        tr("Two cursors: the curves' values at A and at B, and their differences. Drag them, type "
           "their places, or move A with Shift and arrows, B with Ctrl+Shift and arrows."));
    nameShortcut(*toggle);
}

QString PlotCursors::letter(std::size_t cursor) {
    return cursor == 0 ? QStringLiteral("A") : QStringLiteral("B");
}

std::optional<double> PlotCursors::at(std::size_t cursor) const {
    const std::optional<double>& kept = m_kept.at(cursor);
    return kept && m_subject.place ? m_subject.place(*kept) : kept;
}

void PlotCursors::moveTo(std::size_t cursor, double x) {
    m_kept.at(cursor) = m_subject.keep ? m_subject.keep(x) : x;
    layer()->replot();
    emit moved();
}

/// The first time within the visible range.
void PlotCursors::showThem(bool on) {
    const std::vector<QCPAxisRect*> all = rects();
    const bool first = on && !m_kept.front() && !all.empty();
    if (first) {
        const QCPRange visible = all.front()->axis(QCPAxis::atBottom)->range();
        const QCPRange span = m_subject.span();
        const double low = std::max(visible.lower, span.lower);
        const double high = std::max(std::min(visible.upper, span.upper), low);
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            moveTo(cursor, rounded(low + firstPlaces[cursor] * (high - low)));
        }
    }
    layer()->replot();
    emit shownChanged();
}

// --- drawing ------------------------------------------------------------------------------------

std::vector<QCPAxisRect*> PlotCursors::rects() const {
    std::vector<QCPAxisRect*> all;
    for (QCPAxisRect* rect : mParentPlot->axisRects()) {
        if (rect->axisCount(QCPAxis::atBottom) > 0) {
            all.push_back(rect);
        }
    }
    return all;
}

void PlotCursors::draw(QCPPainter* painter) {
    if (!toggle->isChecked()) {
        return;
    }
    const QColor colour = mParentPlot->palette().color(QPalette::Text);
    const std::vector<QCPAxisRect*> all = rects();
    for (const QCPAxisRect* rect : all) {
        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        const bool top = std::ranges::none_of(all, [rect](const QCPAxisRect* other) {
            return other->left() == rect->left() && other->top() < rect->top();
        });
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            const std::optional<double> place = at(cursor);
            if (!place || !axis->range().contains(*place)) {
                continue;
            }
            const double x = axis->coordToPixel(*place);
            painter->setPen(QPen(colour, 1, cursor == 0 ? Qt::SolidLine : Qt::DashLine));
            painter->drawLine(QLineF(x, rect->top(), x, rect->bottom()));
            if (top) {
                drawTag(*painter, *rect, cursor, x);
            }
        }
    }
}

/// A's letter is left of its line and B's right, so that both are legible when they meet.
void PlotCursors::drawTag(QCPPainter& painter, const QCPAxisRect& rect, std::size_t cursor,
                          double x) const {
    const QFontMetricsF metrics(mParentPlot->font());
    const QString text = letter(cursor);
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * tagPadding, metrics.height());
    double left = cursor == 0 ? x - size.width() : x;
    left = std::clamp(left, double(rect.left()),
                      std::max(rect.right() - size.width(), double(rect.left())));
    const QRectF box(QPointF(left, rect.top()), size);
    const QPalette palette = mParentPlot->palette();
    painter.setPen(QPen(palette.color(QPalette::Text), 0));
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawRect(box);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(mParentPlot->font());
    painter.drawText(box, Qt::AlignCenter, text);
}

// --- mouse and keys -----------------------------------------------------------------------------

/// The nearest within reach; of two at one place the one the mouse is on the side of.
std::optional<std::size_t> PlotCursors::cursorAt(const QPointF& at) const {
    std::optional<std::size_t> nearest;
    double least = mouseReach;
    for (const QCPAxisRect* rect : rects()) {
        if (!rect->rect().contains(at.toPoint())) {
            continue;
        }
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            if (const std::optional<double> place = this->at(cursor)) {
                const double away = at.x() - rect->axis(QCPAxis::atBottom)->coordToPixel(*place);
                if (std::abs(away) < least || (std::abs(away) == least && away > 0)) {
                    least = std::abs(away);
                    nearest = cursor;
                }
            }
        }
    }
    return nearest;
}

double PlotCursors::rounded(double x) const {
    const std::vector<QCPAxisRect*> all = rects();
    const QCPAxisRect* rect = m_pressedIn ? m_pressedIn : all.empty() ? nullptr : all.front();
    if (!rect) {
        return x;
    }
    const double pixel = rect->axis(QCPAxis::atBottom)->range().size() / std::max(rect->width(), 1);
    if (!(pixel > 0) || !std::isfinite(pixel)) {
        return x;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(pixel)));
    return plainPlace(std::round(x / unit) * unit);
}

void PlotCursors::dragTo(const QPointF& at) {
    const QCPRange span = m_subject.span();
    const double x = m_pressedIn->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
    moveTo(*m_dragged, std::clamp(rounded(x), span.lower, span.upper));
}

/// Whether the event was for a cursor.
bool PlotCursors::onMouse(QMouseEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        if (event.button() == Qt::LeftButton) {
            m_dragged = cursorAt(event.position());
            m_pressedIn = mParentPlot->axisRectAt(event.position());
        }
        return m_dragged && event.button() == Qt::LeftButton;
    case QEvent::MouseMove: {
        if (m_dragged) {
            dragTo(event.position());
            return true;
        }
        const bool over = event.buttons() == Qt::NoButton && cursorAt(event.position());
        if (over != m_pointing) {
            m_pointing = over;
            over ? mParentPlot->setCursor(Qt::SplitHCursor) : mParentPlot->unsetCursor();
        }
        return false; // the values under the mouse remain visible
    }
    case QEvent::MouseButtonRelease:
        if (m_dragged && event.button() == Qt::LeftButton) {
            m_dragged.reset();
            m_pressedIn = nullptr;
            return true;
        }
        return false;
    default: return false;
    }
}

bool PlotCursors::onKey(const QKeyEvent& event) {
    const std::optional<std::size_t> cursor = cursorOf(event);
    if (cursor) {
        step(*cursor, event.key() == Qt::Key_Right ? 1 : -1);
    }
    return cursor.has_value();
}

/// Steps towards the right of the screen; from outside the visible range to its edge.
void PlotCursors::step(std::size_t cursor, int steps) {
    const std::vector<QCPAxisRect*> all = rects();
    if (all.empty() || !at(cursor)) {
        return;
    }
    const QCPAxis* axis = all.front()->axis(QCPAxis::atBottom);
    const QCPRange visible = axis->range(), span = m_subject.span();
    const double side = axis->rangeReversed() ? -steps : steps;
    const double x = std::clamp(*at(cursor), visible.lower, visible.upper);
    moveTo(cursor,
           std::clamp(rounded(x + side * stepShare * visible.size()), span.lower, span.upper));
}

bool PlotCursors::takes(QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: return onMouse(static_cast<QMouseEvent&>(event));
    case QEvent::ShortcutOverride: return cursorOf(static_cast<QKeyEvent&>(event)).has_value();
    case QEvent::KeyPress: return onKey(static_cast<QKeyEvent&>(event));
    default: return false;
    }
}

bool PlotCursors::eventFilter(QObject* watched, QEvent* event) {
    if (shown() && takes(*event)) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) {
        emit shownChanged();
    }
    return PaintedLayer::eventFilter(watched, event);
}

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
    m_difference->setAccessibleName(tr("Distance of the cursors"));
    for (std::size_t cursor = 0; cursor < PlotCursors::count; ++cursor) {
        m_fields[cursor]->setAccessibleName(
            tr("Place of cursor %1").arg(PlotCursors::letter(cursor)));
        m_fields[cursor]->retranslate();
    }
    follow();
}

} // namespace sparkout
