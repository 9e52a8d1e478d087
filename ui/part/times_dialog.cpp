// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/times_dialog.h"

#include "ui/form/struct_form.h"
#include "ui/kit/answer_buttons.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/part/piece_time_text.h"
#include "ui/text/texts.h"

#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace sparkout {

TimesDialog::TimesDialog(const SetupTimes& times, const WheelWear& wear, std::size_t surfaces,
                         std::optional<double> cycles_min, QWidget* parent)
    : QDialog(parent)
    , m_times(times)
    , m_wear(wear)
    , m_surfaces(surfaces)
    , m_cycles_min(cycles_min)
    , m_result(new QLabel(this)) {
    setWindowTitle(tr("Standard times and wheel wear"));
    setHelpTopic(*this, QStringLiteral("surfaces#times"));
    m_result->setObjectName(QStringLiteral("pieceTime"));
    m_result->setTextFormat(Qt::RichText);
    m_result->setWordWrap(true);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    const auto addBox = [&]<class T>(T& value) {
        auto* box = new QGroupBox(structText(tableOf<T>().name), page);
        auto* form = StructForm::over(value, box);
        (new QVBoxLayout(box))->addWidget(form);
        column->addWidget(box);
        connect(form, &StructForm::edited, this, &TimesDialog::follow);
    };
    addBox(m_times);
    addBox(m_wear);
    auto* area = new QScrollArea(this);
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    auto* buttons = new AnswerButtons(tr("&Apply"), tr("&Cancel"), this);
    m_apply = buttons->acceptButton();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(m_result);
    layout->addWidget(buttons);
    area->setMinimumWidth(page->minimumSizeHint().width()
                          + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    resize(atFontSize(520), atFontSize(600));
    follow();
}

void TimesDialog::follow() {
    m_result->setText(withIndices(pieceTimeText(m_times, m_surfaces, m_cycles_min))
                          .replace(u'\n', QStringLiteral("<br>")));
    m_apply->setEnabled(StructForm::refusals(*this).empty());
}

} // namespace sparkout
