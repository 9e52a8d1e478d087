// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/form_section.h"

#include "core/project/machine.h"
#include "ui/charts/result_tables.h"
#include "ui/dialogs/value_model.h"
#include "ui/kit/metrics.h"
#include "ui/text/names.h"
#include "ui/views/verdict/narrow_table.h"

#include <QLabel>
#include <QVBoxLayout>

namespace sparkout {

FormSection::FormSection(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_model(new ValueModel(this))
    , m_table(new NarrowTable(*m_model, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::tight);
    layout->addWidget(m_title);
    layout->addWidget(m_table);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    m_title->setMinimumWidth(1);
    m_table->setObjectName(QStringLiteral("formByZone"));
    retranslate();
}

void FormSection::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    showTitle();
    showTable();
    setVisible(m_model->columnCount() > 0);
}

void FormSection::setGreyed(bool grey, const QPalette& palette) {
    m_model->setGreyed(grey);
    m_title->setPalette(palette);
}

void FormSection::retranslate() {
    showTitle();
    m_table->setAccessibleName(tr("Form by zone"));
    m_table->retranslate();
    showTable();
}

void FormSection::showTitle() {
    const bool isKnown = !m_outcome || isRoundnessKnown(*m_outcome->result.project.machine);
    m_title->setText(Names::ofMachine(tr("Form by zone, µm"), isKnown));
}

void FormSection::showTable() {
    m_model->setTable(m_outcome ? formValues(*m_outcome) : ValueTable());
    m_table->fit();
}

} // namespace sparkout
