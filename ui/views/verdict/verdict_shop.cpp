// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/verdict_shop.h"

#include "ui/charts/result_tables.h"
#include "ui/dialogs/value_model.h"
#include "ui/kit/theme_icon.h"
#include "ui/views/verdict/narrow_table.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QVBoxLayout>

namespace sparkout {

namespace {
constexpr int iconSize = 13;
} // namespace

ShopSection::ShopSection(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_model(new ValueModel(this))
    , m_table(new NarrowTable(*m_model, this))
    , m_remarksLine(new QWidget(this))
    , m_icon(new QLabel(m_remarksLine))
    , m_remarks(new QLabel(m_remarksLine)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addWidget(m_table);
    layout->addWidget(m_remarksLine);
    auto* line = new QHBoxLayout(m_remarksLine);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_icon, 0, Qt::AlignTop);
    line->addWidget(m_remarks, 1);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (QLabel* label : {m_title, m_remarks}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setMinimumWidth(1);
    }
    m_remarks->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_remarks->setObjectName(QStringLiteral("shopRemarks"));
    m_table->setObjectName(QStringLiteral("shop"));
    retranslate();
}

void ShopSection::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    showTable();
}

void ShopSection::setGreyed(bool grey, const QPalette& palette) {
    m_model->setGreyed(grey);
    m_title->setPalette(palette);
    m_remarks->setPalette(palette);
}

void ShopSection::showTable() {
    m_model->setTable(m_outcome ? shopTable(*m_outcome) : ValueTable());
    const QStringList sentences = m_outcome ? shopRemarks(m_outcome->shop) : QStringList();
    m_remarks->setText(sentences.join(QLatin1Char('\n')));
    m_remarksLine->setVisible(!sentences.isEmpty());
    m_icon->setPixmap(themeIcon(u"warning").pixmap(QSize(iconSize, iconSize), devicePixelRatioF()));
    m_table->fit();
}

void ShopSection::retranslate() {
    m_title->setText(tr("Grinding figures by stage"));
    m_table->setAccessibleName(tr("Grinding figures by stage"));
    m_remarks->setAccessibleName(tr("Values outside the usual range"));
    m_table->retranslate();
    showTable();
}

} // namespace sparkout
