// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/data_choice.h"

#include "core/identification/fit_data.h"
#include "core/project/measured.h"
#include "ui/identification/fit_words.h"
#include "ui/kit/metrics.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

DataChoice::DataChoice(const Project& project, QWidget* parent) : QGroupBox(parent) {
    setTitle(tr("Measurements"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics::row);
    if (!project.measured) {
        return;
    }
    const std::vector<MeasuredTrace>& traces = project.measured->traces;
    const FitData all = fitDataOf(project, {}, true);
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const int number = static_cast<int>(i);
        QCheckBox* const box = add(FitWords::trace(traces[i]), QStringLiteral("trace%1").arg(i));
        const bool isUsable =
            std::ranges::find(all.groups, number, &FitGroup::trace) != all.groups.end();
        box->setEnabled(isUsable);
        box->setChecked(isUsable);
        if (std::ranges::find(all.withoutFactor, number) != all.withoutFactor.end()) {
            box->setToolTip(tr("A current is used once its factor in kW per A is given."));
        }
        m_traces.push_back(box);
        m_numbers.push_back(number);
    }
    const auto parts = std::ranges::find(all.groups, FitSource::parts, &FitGroup::source);
    if (parts != all.groups.end()) {
        m_parts =
            add(tr("diameters of parts (n = %1)").arg(parts->measured), QStringLiteral("parts"));
        m_parts->setChecked(all.groups.size() == 1); // their cycles may differ from that of a trace
    }
}

QCheckBox* DataChoice::add(const QString& text, const QString& name) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(name);
    layout()->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &DataChoice::changed);
    return box;
}

std::vector<int> DataChoice::traces() const {
    std::vector<int> chosen;
    for (std::size_t i = 0; i < m_traces.size(); ++i) {
        if (m_traces[i]->isChecked()) {
            chosen.push_back(m_numbers[i]);
        }
    }
    return chosen;
}

bool DataChoice::withParts() const {
    return m_parts && m_parts->isChecked();
}

} // namespace sparkout
