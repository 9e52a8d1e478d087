// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/parameter_choice.h"

#include "core/identification/cycle_response.h"
#include "core/process/force.h"
#include "core/project/part.h"
#include "ui/fields/number_field.h"
#include "ui/identification/fit_words.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int mostPlaceRows = 12; ///< sections with a row each
constexpr int priorWidth = 64;

} // namespace

ParameterChoice::ParameterChoice(const Project& project, QWidget* parent) : QGroupBox(parent) {
    setTitle(tr("Parameters"));
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    grid->setColumnStretch(0, 1);
    addHead(*grid);
    const int places = placeCount(project);
    for (int i = 0; i < static_cast<int>(FittedKind::count_); ++i) {
        const auto kind = static_cast<FittedKind>(i);
        if (kind == FittedKind::blank_runout && project.part->profile == ProfileForm::measured) {
            continue; // its form is given point by point
        }
        if (hasThreshold(project)
            && (kind == FittedKind::flow_stress || kind == FittedKind::dullness)) {
            continue; // the force does not depend on them
        }
        addRow(*grid, project, {kind, {}, {}});
        const bool byPlace = kind == FittedKind::compliance && hasPlaceCompliances(project)
                             && places > 1 && places <= mostPlaceRows;
        for (int place = 0; byPlace && place < places; ++place) {
            addRow(*grid, project, {kind, place, {}});
        }
    }
}

void ParameterChoice::addHead(QGridLayout& grid) {
    auto* known = new QLabel(tr("known before: mean ± s"), this);
    known->setToolTip(tr("A value known from elsewhere, with its standard deviation, counts as one "
                         "more measurement. Factors refer to the current inputs: 1 ± 0.1 means "
                         "known within about 20 %. Empty: nothing is known."));
    grid.addWidget(known, 0, 1, 1, 4, Qt::AlignLeft);
}

void ParameterChoice::addRow(QGridLayout& grid, const Project& project,
                             const FittedParameter& parameter) {
    const QString name = FitWords::parameter(project, parameter);
    const QString key = QString::fromLatin1(keyOf(parameter.kind))
                        + (parameter.place ? QString::number(*parameter.place) : QString());
    const auto field = [&](const QString& part, const QString& text, const Range& range) {
        NumberSpec spec;
        spec.hard = range;
        spec.optional = true;
        auto* number = new NumberField(spec, this);
        number->setObjectName(key + part);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        number->setAccessibleName(text.arg(name));
        setTextWidth(*number, priorWidth);
        connect(number, &NumberField::valueEdited, this, &ParameterChoice::changed);
        connect(number, &NumberField::remarkChanged, this, &ParameterChoice::changed);
        return number;
    };
    const Range positive{.low = 0, .lowOpen = true}, any;
    auto* box = new QCheckBox(name, this);
    box->setObjectName(key);
    Row row{parameter, box,
            field(QStringLiteral("Mean"), tr("%1: mean known before"),
                  isFactor(parameter.kind) ? positive : any),
            field(QStringLiteral("Deviation"), tr("%1: its standard deviation"), positive)};
    const int line = grid.rowCount();
    grid.addWidget(row.box, line, 0);
    grid.addWidget(row.mean, line, 1);
    grid.addWidget(new QLabel(QStringLiteral("±"), this), line, 2);
    grid.addWidget(row.deviation, line, 3);
    grid.addWidget(new QLabel(FitWords::unit(parameter.kind), this), line, 4);
    connect(row.box, &QCheckBox::toggled, this, [this, row](bool fitted) {
        row.mean->setEnabled(fitted);
        row.deviation->setEnabled(fitted);
        emit changed();
    });
    row.mean->setEnabled(false);
    row.deviation->setEnabled(false);
    m_rows.push_back(row);
}

void ParameterChoice::propose(const FitData& measured) {
    const bool isOfSources =
        std::ranges::any_of(m_rows, [](const Row& row) { // otherwise it has no such row
            return row.parameter.kind == FittedKind::dullness;
        });
    const std::vector<FittedKind> kinds = proposedParameters(measured, !isOfSources);
    for (const Row& row : m_rows) {
        row.box->setChecked(!row.parameter.place
                            && std::ranges::find(kinds, row.parameter.kind) != kinds.end());
    }
}

void ParameterChoice::setChecked(const FittedParameter& parameter, bool checked) {
    for (const Row& row : m_rows) {
        if (row.parameter.kind == parameter.kind && row.parameter.place == parameter.place) {
            row.box->setChecked(checked);
        }
    }
}

std::vector<FittedParameter> ParameterChoice::parameters() const {
    std::vector<FittedParameter> list;
    for (const Row& row : m_rows) {
        if (!row.box->isChecked()) {
            continue;
        }
        FittedParameter parameter = row.parameter;
        if (row.mean->value() && row.deviation->value()) {
            parameter.prior = Prior{*row.mean->value(), *row.deviation->value()};
        }
        list.push_back(parameter);
    }
    return list;
}

QString ParameterChoice::fault() const {
    for (const Row& row : m_rows) {
        if (!row.box->isChecked()) {
            continue;
        }
        for (const NumberField* field : {row.mean, row.deviation}) {
            if (field->refused()) {
                return tr("%1: %2").arg(row.box->text(), field->refusal());
            }
        }
        if (row.mean->value().has_value() != row.deviation->value().has_value()) {
            return tr("%1: a mean known before needs its standard deviation, and the other way "
                      "round.")
                .arg(row.box->text());
        }
    }
    return {};
}

} // namespace sparkout
