// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/times_dialog.h"

#include "core/project/member.h"
#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/part/piece_time_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

TimesDialog::TimesDialog(const SetupTimes& times, const WheelWear& wear, std::size_t surfaces,
                         std::optional<double> cycles_min, QWidget* parent)
    : QDialog(parent)
    , m_times(times)
    , m_wear(wear)
    , m_surfaces(surfaces)
    , m_cycles_min(cycles_min)
    , m_result(new QLabel(this))
    , m_buttons(new QDialogButtonBox(this)) {
    setWindowTitle(tr("Standard times and wheel wear"));
    setHelpTopic(*this, QStringLiteral("surfaces#times"));
    m_result->setObjectName(QStringLiteral("pieceTime"));
    m_result->setTextFormat(Qt::RichText);
    m_result->setWordWrap(true);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    const auto addBox = [&](const StructInfo& table, void* owner) {
        auto* box = new QGroupBox(structText(table.name), page);
        auto* form = new QFormLayout(box);
        addRows(*form, table, owner);
        column->addWidget(box);
    };
    addBox(tableOf<SetupTimes>(), &m_times);
    addBox(tableOf<WheelWear>(), &m_wear);
    auto* area = new QScrollArea(this);
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* take = m_buttons->addButton(tr("&Apply"), QDialogButtonBox::AcceptRole);
    m_buttons->addButton(tr("&Cancel"), QDialogButtonBox::RejectRole);
    take->setDefault(true);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(m_result);
    layout->addWidget(m_buttons);
    area->setMinimumWidth(page->minimumSizeHint().width()
                          + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    resize(atFontSize(520), atFontSize(600));
    follow();
}

void TimesDialog::addRows(QFormLayout& form, const StructInfo& table, void* owner) {
    for (const Field& field : table.fields) {
        auto* number = new NumberField(NumberSpec::of(field), this);
        number->setObjectName(QString::fromUtf8(field.key));
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        setTextWidth(*number, metrics::fieldWide);
        number->setValue(numberIn(field, owner));
        number->setToolTip(hintMarkup(field));
        number->setHint(hintPlain(field));
        number->setAccessibleName(
            *field.unit ? tr("%1, %2").arg(inputText(field.label), unitText(field.unit))
                        : inputText(field.label));
        auto* label = new QLabel(labelMarkup(field), this);
        label->setTextFormat(Qt::RichText);
        label->setBuddy(number);
        auto* line = new QHBoxLayout;
        line->addWidget(number);
        line->addWidget(new QLabel(unitText(field.unit), this));
        line->addStretch();
        form.addRow(label, line);
        connect(number, &NumberField::valueEdited, this, [this, number, &field, owner] {
            const bool needed = field.kind == Kind::number || field.kind == Kind::integer;
            if (number->value() || !needed) {
                setNumberIn(field, owner, number->value());
            }
            follow();
        });
        connect(number, &NumberField::remarkChanged, this, &TimesDialog::follow);
        m_fields.push_back(number);
    }
}

void TimesDialog::follow() {
    m_result->setText(withIndices(pieceTimeText(m_times, m_surfaces, m_cycles_min))
                          .replace(u'\n', QStringLiteral("<br>")));
    m_buttons->buttons().front()->setEnabled(std::ranges::none_of(m_fields, &NumberField::refused));
}

} // namespace sparkout
