// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/curve_answer.h"

#include "ui/form/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/text/goal_text.h"
#include "ui/text/number_text.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace sparkout {

/// A small plot on which a curve is drawn by points: a click puts the point of the nearest place at
/// that height, dragging moves it; by keys, Left and Right choose a place, Up and Down move its
/// point, Delete removes it. The engine's curve can be drawn beside the prediction.
class CurveSketch : public QWidget {
public:
    using Values = std::vector<std::optional<double>>;
    using Placed = std::function<void(std::size_t place, std::optional<double> value)>;

    /// The places in their order, at these distances.
    CurveSketch(std::vector<double> at, QWidget* parent);

    void setPlaced(Placed placed) { m_placed = std::move(placed); } ///< called for a point by hand

    void setLabels(QStringList places, QString along, QString value);
    void setCurveNames(QString said, QString found);
    void setSaid(const Values& values);
    void setFound(const Values& values);
    void setTop(double top); ///< least upper end of the axis
    void setEditable(bool editable);
    [[nodiscard]] double top() const; ///< upper end of the axis as drawn
    [[nodiscard]] QPointF pointAt(std::size_t place, double value) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int headHeight() const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] double bottom() const;
    [[nodiscard]] double tick() const;
    void place(const QPointF& at);
    void drawAxes(QPainter& painter) const;
    void drawCurve(QPainter& painter, const Values& values, bool isFound) const;
    void drawNames(QPainter& painter) const;

    Placed m_placed;
    std::vector<double> m_at;
    QStringList m_places;
    QString m_along, m_value, m_saidName, m_foundName;
    Values m_said, m_found;
    double m_top = 10;
    bool m_isEditable = true;
    std::size_t m_current = 0;
};

namespace {

constexpr int sketchWidth = 260, sketchHeight = 190, ticks = 5, stepsOfAxis = 100, keySteps = 50;
constexpr double roomAboveCurve = 1.08; ///< relative to the highest point

/// The next of 1, 2, 5, 10, … from a value on.
double roundTick(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double each : {1.0, 2.0, 5.0}) {
        if (each * power >= value * (1 - 1e-9)) {
            return each * power;
        }
    }
    return 10 * power;
}

double snapped(double value, double step) {
    return std::round(value / step) * step;
}

} // namespace

CurveSketch::CurveSketch(std::vector<double> at, QWidget* parent)
    : QWidget(parent), m_at(std::move(at)) {
    m_said.resize(m_at.size());
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::CrossCursor);
}

QSize CurveSketch::sizeHint() const {
    return {atFontSize(sketchWidth), atFontSize(sketchHeight)};
}

void CurveSketch::setLabels(QStringList places, QString along, QString value) {
    m_places = std::move(places);
    m_along = std::move(along);
    m_value = std::move(value);
    update();
}

void CurveSketch::setCurveNames(QString said, QString found) {
    m_saidName = std::move(said);
    m_foundName = std::move(found);
    update();
}

void CurveSketch::setSaid(const Values& values) {
    m_said = values;
    update();
}

void CurveSketch::setFound(const Values& values) {
    m_found = values;
    update();
}

void CurveSketch::setTop(double top) {
    m_top = top;
    update();
}

void CurveSketch::setEditable(bool editable) {
    m_isEditable = editable;
    setFocusPolicy(editable ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(editable ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

double CurveSketch::top() const {
    double most = m_top;
    for (const Values* values : {&m_said, &m_found}) {
        for (const auto& value : *values) {
            if (value && *value > most) {
                most = *value * roomAboveCurve;
            }
        }
    }
    return most;
}

double CurveSketch::bottom() const {
    double least = 0;
    for (const Values* values : {&m_said, &m_found}) {
        for (const auto& value : *values) {
            least = std::min(least, value.value_or(0) * roomAboveCurve);
        }
    }
    return least;
}

double CurveSketch::tick() const {
    return roundTick((top() - bottom()) / ticks);
}

/// The height of the heading with as many lines as needed.
int CurveSketch::headHeight() const {
    return fontMetrics()
        .boundingRect(QRect(0, 0, width() - metrics::tight, height()), Qt::TextWordWrap, m_value)
        .height();
}

QRectF CurveSketch::area() const {
    const QFontMetrics text = fontMetrics();
    int widest = 0;
    for (double at = std::ceil(bottom() / tick()) * tick(); at <= top(); at += tick()) {
        widest = std::max(widest, text.horizontalAdvance(printedNumber(at)));
    }
    const int line = text.height();
    return QRectF(rect()).adjusted(widest + metrics::margin, headHeight() + 1.4 * line,
                                   -metrics::wide, -2.2 * line);
}

QPointF CurveSketch::pointAt(std::size_t place, double value) const {
    const QRectF in = area();
    const double from = m_at.front(), to = m_at.back();
    const double share = to > from ? (m_at[place] - from) / (to - from) : 0.5;
    return {in.left() + share * in.width(),
            in.bottom() - (value - bottom()) / (top() - bottom()) * in.height()};
}

void CurveSketch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    drawAxes(painter);
    drawCurve(painter, m_said, false);
    drawCurve(painter, m_found, true);
    drawNames(painter);
    if (hasFocus() && m_isEditable) {
        const QPointF at = pointAt(m_current, m_said[m_current].value_or(bottom()));
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, 8, 8);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
        painter.drawLine(QPointF(at.x(), area().top()), QPointF(at.x(), area().bottom()));
    }
}

void CurveSketch::drawAxes(QPainter& painter) const {
    const QRectF in = area();
    const QColor ink = palette().color(QPalette::Text);
    QColor grid = ink;
    grid.setAlphaF(0.2F);
    const int line = fontMetrics().height();
    for (double at = std::ceil(bottom() / tick()) * tick(); at <= top() * (1 + 1e-9);
         at += tick()) {
        const double y = pointAt(0, at).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(0, y - line / 2.0, in.left() - metrics::tight, line),
                         Qt::AlignRight | Qt::AlignVCenter, printedNumber(snapped(at, tick())));
    }
    painter.setPen(ink);
    painter.drawLine(in.bottomLeft(), in.bottomRight());
    painter.drawLine(in.topLeft(), in.bottomLeft());
    double free = -1;
    for (std::size_t i = 0; i < m_at.size() && qsizetype(i) < m_places.size(); ++i) {
        const double x = pointAt(i, 0).x();
        const QString& text = m_places[qsizetype(i)];
        const double half = fontMetrics().horizontalAdvance(text) / 2.0;
        painter.drawLine(QPointF(x, in.bottom()), QPointF(x, in.bottom() + 3));
        if (x - half > free) { // otherwise it would overlap the previous one
            painter.drawText(QRectF(x - half - 1, in.bottom() + 4, 2 * half + 2, line),
                             Qt::AlignCenter, text);
            free = x + half + metrics::tight;
        }
    }
    painter.drawText(QRectF(in.left(), height() - line - 1, in.width(), line), Qt::AlignCenter,
                     m_along);
    painter.drawText(QRectF(metrics::hair, 0, width() - metrics::tight, headHeight()),
                     Qt::AlignLeft | Qt::TextWordWrap, m_value);
}

/// The prediction is a solid line with discs, the result a dashed one with squares.
void CurveSketch::drawCurve(QPainter& painter, const Values& values, bool isFound) const {
    const QColor colour = tone(isFound ? Tone::vermilion : Tone::blue, palette());
    painter.setPen(QPen(colour, 2, isFound ? Qt::DashLine : Qt::SolidLine));
    std::optional<QPointF> before;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) {
            const QPointF at = pointAt(i, *values[i]);
            if (before) {
                painter.drawLine(*before, at);
            }
            before = at;
        }
    }
    painter.setPen(QPen(colour, 1));
    painter.setBrush(colour);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) {
            const QPointF at = pointAt(i, *values[i]);
            constexpr double half = 3.5;
            if (isFound) {
                painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
            } else {
                painter.drawEllipse(at, half, half);
            }
        }
    }
}

void CurveSketch::drawNames(QPainter& painter) const {
    const int line = fontMetrics().height();
    const double below = headHeight() + 0.2 * line;
    double x = area().left();
    const auto name = [&](const QString& text, Tone colour, Qt::PenStyle style) {
        constexpr int sample = 22;
        painter.setPen(QPen(tone(colour, palette()), 2, style));
        const double y = below + line / 2.0;
        painter.drawLine(QPointF(x, y), QPointF(x + sample, y));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x + sample + metrics::tight, below + fontMetrics().ascent()),
                         text);
        x += sample + metrics::wide + fontMetrics().horizontalAdvance(text);
    };
    name(m_saidName, Tone::blue, Qt::SolidLine);
    if (!m_found.empty()) {
        name(m_foundName, Tone::vermilion, Qt::DashLine);
    }
}

void CurveSketch::place(const QPointF& at) {
    if (!m_isEditable) {
        return;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < m_at.size(); ++i) {
        if (std::abs(pointAt(i, 0).x() - at.x()) < std::abs(pointAt(nearest, 0).x() - at.x())) {
            nearest = i;
        }
    }
    const QRectF in = area();
    const double share = std::clamp((in.bottom() - at.y()) / in.height(), 0.0, 1.0);
    const double step = roundTick((top() - bottom()) / stepsOfAxis);
    m_current = nearest;
    m_placed(nearest, snapped(bottom() + share * (top() - bottom()), step));
}

void CurveSketch::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        place(event->position());
    }
}

void CurveSketch::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) {
        place(event->position());
    }
}

void CurveSketch::keyPressEvent(QKeyEvent* event) {
    if (!m_isEditable) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double step = roundTick((top() - bottom()) / keySteps);
    const double now = m_said[m_current].value_or(bottom());
    switch (event->key()) {
    case Qt::Key_Left: m_current -= m_current > 0 ? 1 : 0; break;
    case Qt::Key_Right: m_current += m_current + 1 < m_at.size() ? 1 : 0; break;
    case Qt::Key_Up: m_placed(m_current, snapped(now + step, step)); break;
    case Qt::Key_Down: m_placed(m_current, snapped(now - step, step)); break;
    case Qt::Key_Delete: m_placed(m_current, std::nullopt); break;
    default: QWidget::keyPressEvent(event); return;
    }
    update();
}

void CurveSketch::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void CurveSketch::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

namespace {

constexpr double usualTop = 10;
constexpr int typedField = 72, besideEachOther = 2;

NumberSpec valueSpec(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.optional = true;
    return spec;
}

NumberSpec topSpec(const Figure& figure) {
    NumberSpec spec;
    spec.unit = rowOf(figure.name).unit;
    spec.hard = {1e-6, 1e9};
    return spec;
}

} // namespace

CurveAnswer::CurveAnswer(CurvePrediction goal, const Project& project, QWidget* parent)
    : AnswerField(parent)
    , m_goal(std::move(goal))
    , m_project(project)
    , m_sketch(new CurveSketch(m_goal.at, this))
    , m_note(new QLabel(this))
    , m_topLabel(new QLabel(this))
    , m_top(new NumberField(topSpec(m_goal.figure), this))
    , m_topRow(new QWidget(this))
    , m_head(new QLabel(this)) {
    m_sketch->setObjectName(QStringLiteral("curveSketch"));
    m_note->setWordWrap(true);
    m_head->setWordWrap(true);
    m_top->setObjectName(QStringLiteral("curveTop"));
    m_top->setValue(usualTop);
    m_topLabel->setBuddy(m_top);
    setTextWidth(*m_top, typedField);
    auto* top = new QHBoxLayout(m_topRow);
    top->setContentsMargins(0, 0, 0, 0);
    top->addWidget(m_topLabel, 1);
    top->addWidget(m_top);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::gap);
    layout->addWidget(m_note);
    layout->addWidget(m_sketch);
    layout->addWidget(m_topRow);
    layout->addWidget(m_head);
    buildFields();
    connect(m_top, &NumberField::valueEdited, this,
            [this] { m_sketch->setTop(m_top->value().value_or(usualTop)); });
    m_sketch->setPlaced([this](std::size_t place, std::optional<double> value) {
        m_fields[place]->reset(value);
        showSketch();
        emit edited();
    });
    CurveAnswer::retranslate();
}

void CurveAnswer::buildFields() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    const auto lines =
        (m_goal.at.size() + besideEachOther - 1) / besideEachOther; // from top to bottom
    for (std::size_t i = 0; i < m_goal.at.size(); ++i) {
        auto* label = new QLabel(this);
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto* field = new NumberField(valueSpec(m_goal.figure), this);
        field->setObjectName(QStringLiteral("curveValue%1").arg(i + 1));
        setTextWidth(*field, typedField);
        label->setBuddy(field);
        const int row = static_cast<int>(i % lines), column = static_cast<int>(i / lines) * 2;
        grid->addWidget(label, row, column);
        grid->addWidget(field, row, column + 1);
        connect(field, &NumberField::valueEdited, this, [this] {
            showSketch();
            emit edited();
        });
        m_places.push_back(label);
        m_fields.push_back(field);
    }
    grid->setColumnStretch(2 * besideEachOther, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

void CurveAnswer::showSketch() {
    CurveSketch::Values values;
    for (const NumberField* field : m_fields) {
        values.push_back(field->value());
    }
    m_sketch->setSaid(values);
}

void CurveAnswer::show(const Answer& answer) {
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        std::optional<double> value;
        for (const auto& row : answer.curve.value_or(std::vector<std::vector<double>>())) {
            if (row.size() == 2 && row[0] == m_goal.at[i]) {
                value = row[1];
            }
        }
        m_fields[i]->reset(value);
    }
    showSketch();
}

void CurveAnswer::put(Answer& answer) const {
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (const auto value = m_fields[i]->value()) {
            rows.push_back({m_goal.at[i], *value});
        }
    }
    answer.curve.reset();
    if (!rows.empty()) {
        answer.curve = std::move(rows);
    }
}

bool CurveAnswer::isWhole() const {
    return std::ranges::all_of(m_fields, [](const NumberField* field) {
        return field->value().has_value() && !field->refused();
    });
}

void CurveAnswer::lock() {
    m_sketch->setEditable(false);
    m_topRow->hide();
    for (NumberField* field : m_fields) {
        field->setEnabled(false);
    }
}

void CurveAnswer::showResult(const GoalResult& result) {
    CurveSketch::Values values;
    for (const ComparedPoint& point : result.curve) {
        values.emplace_back(point.value);
    }
    m_sketch->setFound(values);
    if (!values.empty()) {
        double most = 0;
        for (const auto& value : values) {
            most = std::max(most, value.value_or(0));
        }
        m_sketch->setTop(std::max(most, 1e-6)); // includes the prediction
    }
    retranslate();
}

void CurveAnswer::retranslate() {
    const QString unit = GoalText::unit(m_goal.figure);
    const QString value = GoalText::quantityAndUnit(m_goal.figure, m_project);
    const QString along = GoalText::along(m_goal, m_project);
    m_note->setText(tr("Click into the plot for each point, or type the values below it."));
    m_note->setVisible(!m_topRow->isHidden());
    m_topLabel->setText(unit.isEmpty() ? tr("The axis goes up to")
                                       : tr("The axis goes up to, %1").arg(unit));
    m_top->setAccessibleName(m_topLabel->text());
    m_top->retranslate();
    m_head->setText(tr("%1 and value").arg(along));
    QStringList places;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const QString place = GoalText::alongAt(m_goal, m_goal.at[i], m_project);
        places += place;
        m_places[i]->setText(place);
        m_fields[i]->setAccessibleName(tr("%1 %2: %3").arg(along, place, value));
        m_fields[i]->retranslate();
    }
    m_sketch->setLabels(places, along, value);
    m_sketch->setCurveNames(tr("prediction"), tr("result"));
    m_sketch->setAccessibleName(tr("Your curve: %1").arg(value));
    m_sketch->setAccessibleDescription(
        tr("Left and Right choose a place, Up and Down move its point, Del removes it."));
}

} // namespace sparkout
