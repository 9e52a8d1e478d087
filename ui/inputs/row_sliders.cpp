// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/row_sliders.h"

#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/study/stage_edits.h"
#include "ui/form/value_slider.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/list_model.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace sparkout {

QString StockFit::text(const Document& document) {
    const auto& before = document.project().cycle->stages;
    if (before.empty() || document.isOpen("/part/stock_mm") || stocksAddUp(document.project())) {
        return {};
    }
    const Project fitted = withFittedStocks(document.project());
    const auto& after = fitted.cycle->stages;
    const bool firstAlone =
        std::equal(before.begin() + 1, before.end(), after.begin() + 1,
                   [](const Stage& a, const Stage& b) { return a.stock_mm == b.stock_mm; });
    const auto amount = [](double value_mm) {
        const Field& stock = *tableOf<Part>().find("stock_mm");
        const QString number = printedNumber(ShownScale::ofInput(stock).shown(value_mm));
        return StockReading::isOnDiameter(stock)
                   ? tr("%1\u00a0%2 on diameter").arg(number, unitText("mm"))
                   : number + u'\u00a0' + unitText("mm");
    };
    return firstAlone
               ? tr("Fit the stocks: the first stage takes %1").arg(amount(after.front().stock_mm))
               : tr("Fit the stocks in proportion, to %1 together")
                     .arg(amount(document.project().part->stock_mm));
}

void StockFit::apply(Document& document) {
    document.endMerge();
    document.edit(withFittedStocks(document.project()),
                  {"Edit", QT_TRANSLATE_NOOP("Edit", "Fit the stocks of the stages")});
}

namespace {

constexpr int valueWidth = 92;
constexpr int leastSlider = 32; ///< beside a long name and a number with many digits

} // namespace

RowSliders::RowSliders(ListModel& model, Document& document, QWidget& before, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_document(document)
    , m_before(before)
    , m_title(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::row);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    layout->addWidget(m_title);
}

std::vector<int> RowSliders::columns() const {
    std::vector<int> list;
    for (int column = 0; m_row >= 0 && column < m_model.columnCount(); ++column) {
        const QModelIndex index = m_model.index(m_row, column);
        if (m_model.isField(index) && m_model.field(index).slider
            && (m_model.flags(index) & Qt::ItemIsEditable)) {
            list.push_back(column);
        }
    }
    return list;
}

void RowSliders::build() {
    m_lines.clear();
    delete m_body;
    m_body = new QWidget(this);
    m_grid = new QGridLayout(m_body);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(metrics::gap);
    m_grid->setVerticalSpacing(metrics::gap);
    m_grid->setColumnStretch(1, 1);
    layout()->addWidget(m_body);
    for (const int column : columns()) {
        addLine(column);
    }
    QWidget* last = &m_before;
    for (const Line& line : m_lines) {
        setTabOrder(last, line.slider);
        last = line.slider;
    }
}

void RowSliders::addLine(int column) {
    const Field& field = m_model.field(m_model.index(m_row, column));
    const Line line{&field, column, new QLabel(m_body), new ValueSlider(m_body),
                    new QLabel(m_body)};
    line.label->setTextFormat(Qt::RichText);
    line.label->setBuddy(line.slider);
    line.value->setTextFormat(Qt::PlainText);
    setTextMinimumWidth(*line.value, valueWidth);
    line.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line.slider->setMinimumWidth(leastSlider);
    line.slider->setObjectName(QString::fromUtf8(field.key) + QStringLiteral("/slider"));
    setHintField(*line.slider, field);
    const int row = m_grid->rowCount();
    m_grid->addWidget(line.label, row, 0);
    m_grid->addWidget(line.slider, row, 1);
    m_grid->addWidget(line.value, row, 2);
    connect(line.slider, &ValueSlider::valueEdited, this, [this, column](double value) {
        const QModelIndex index = m_model.index(m_row, column);
        m_model.accept(index); // discards a refused text
        m_model.setNumber(index, value);
    });
    connect(line.slider, &ValueSlider::settled, this, [this] { m_document.endMerge(); });
    m_lines.push_back(line);
    retranslate(line);
}

void RowSliders::showRow(int row) {
    const bool another = row != m_row;
    m_row = row;
    const auto wanted = columns();
    const bool same =
        std::equal(wanted.begin(), wanted.end(), m_lines.begin(), m_lines.end(),
                   [this](int column, const Line& line) {
                       return line.column == column
                              && line.field == &m_model.field(m_model.index(m_row, column));
                   });
    if (!same) {
        build();
    } else if (another) {
        retranslate();
    }
    setVisible(!m_lines.empty());
    for (const Line& line : m_lines) {
        showLine(line);
    }
    m_title->setText(tr("%1 %2").arg(structText(m_model.itemName())).arg(m_row + 1));
}

void RowSliders::showLine(const Line& line) {
    const QModelIndex index = m_model.index(m_row, line.column);
    const auto value = m_model.number(index);
    const QString unit = unitText(line.field->unit);
    line.slider->display(sliderSpec(m_document.project(), m_model.path(index), *line.field), value,
                         unit, ShownScale::ofInput(*line.field));
    const QString number =
        value ? printedNumber(ShownScale::ofInput(*line.field).shown(*value)) : QStringLiteral("—");
    line.value->setText(unit.isEmpty() ? number : number + u'\u00a0' + unit);
}

void RowSliders::retranslate(const Line& line) {
    const QString label = StockReading::column(*line.field);
    const QString symbol = symbolMarkup(*line.field);
    line.label->setText(symbol.isEmpty() ? label.toHtmlEscaped()
                                         : label.toHtmlEscaped() + u' ' + symbol);
    const QString hint = hintMarkup(*line.field);
    line.label->setToolTip(hint);
    line.slider->setToolTip(hint);
    line.slider->setAccessibleName(
        tr("%1 %2, %3, slider").arg(structText(m_model.itemName())).arg(m_row + 1).arg(label));
}

void RowSliders::retranslate() {
    setAccessibleName(tr("Sliders of the selected row"));
    for (const Line& line : m_lines) {
        retranslate(line);
    }
    showRow(m_row);
}

ValueSlider* RowSliders::slider(const QString& key) const {
    for (const Line& line : m_lines) {
        if (QString::fromUtf8(line.field->key) == key) {
            return line.slider;
        }
    }
    return nullptr;
}

} // namespace sparkout
