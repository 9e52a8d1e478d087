// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/fit_words.h"

#include "core/measured/fit_data.h"
#include "core/process/force.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QStandardItemModel>

namespace sparkout {

namespace {

QString worded(const MeasuredWords& words) {
    return QCoreApplication::translate("Measured", words.text);
}

FitSource sourceOf(TraceQuantity quantity) {
    switch (quantity) {
    case TraceQuantity::wheel_power:
    case TraceQuantity::spindle_current: return FitSource::power;
    case TraceQuantity::normal_force: return FitSource::force;
    case TraceQuantity::gauge_size: break;
    }
    return FitSource::size;
}

/// Listed parts, or those behind the summaries.
std::int64_t partsMeasured(const Project& project) {
    std::int64_t count = 0;
    for (const FitGroup& group : fitDataOf(project, {}, true).groups) {
        count += group.source == FitSource::parts ? group.measured : 0;
    }
    return count;
}

QString fileOf(const MeasuredTrace& trace) {
    return printableText(QString::fromStdString(trace.source));
}

} // namespace

QString FitWords::place(const Project& project, int place) {
    return project.operation->travels ? Names::zone(static_cast<Zone>(place))
                                      : Names::zone(Zone::section, place);
}

QString FitWords::parameter(const Project& project, const FittedParameter& parameter) {
    const QString name = worded(wordsOf(parameter.kind, hasThreshold(project)));
    return parameter.place
               ? tr("%1, %2", "parameter, zone").arg(name, place(project, *parameter.place))
               : name;
}

QString FitWords::unit(FittedKind kind) {
    return unitText(unitOf(kind));
}

QString FitWords::source(FitSource source) {
    return worded(wordsOf(source));
}

QString FitWords::unit(FitSource source) {
    return unitText(unitOf(source));
}

QString FitWords::trace(const MeasuredTrace& trace) {
    const QString what = trace.quantity == TraceQuantity::spindle_current
                             ? tr("current of the spindle")
                             : source(sourceOf(trace.quantity));
    const QString file = fileOf(trace);
    return file.isEmpty() ? tr("%1 (n = %2)").arg(what).arg(trace.values.size())
                          : tr("%1, %2 (n = %3)").arg(what, file).arg(trace.values.size());
}

QString FitWords::group(const Project& project, const FitResiduals& residuals) {
    const bool isTrace =
        project.measured && residuals.trace >= 0
        && static_cast<std::size_t>(residuals.trace) < project.measured->traces.size();
    return isTrace ? trace(project.measured->traces[static_cast<std::size_t>(residuals.trace)])
                   : tr("%1 (n = %2)").arg(source(residuals.source)).arg(residuals.values.size());
}

QString FitWords::status(IdentificationStatus status) {
    return worded(wordsOf(status));
}

QString FitWords::advice(Advice advice) {
    return worded(wordsOf(advice));
}

QString FitWords::trial(const MeasuredWords& words) {
    return QCoreApplication::translate("Trial", words.text);
}

QString FitWords::outOfStep(const Project& project, const Identification& result,
                            const OutOfStep& one) {
    constexpr double normal95 = 1.96;
    const FittedValue& moved = result.values.at(one.parameter);
    return tr("Left out: %1 seems to be %2 ± %3 and was not fitted. This distorts the values "
              "found: with it fitted, %4 would be %5 instead of %6.")
        .arg(worded(wordsOf(one.kind)), number(one.amount),
             Names::significant(normal95 * one.error, 2) + u' ' + unit(one.kind),
             parameter(project, moved.parameter), number(one.value), number(moved.value));
}

QString FitWords::forceLaw(const ForceLawChoice& choice) {
    const QString found =
        tr("Force law: %1 (%2 revolutions; residuals %3 µm by the sources' law, %4 µm with a "
           "threshold).")
            .arg(worded(wordsOf(choice.supported)))
            .arg(choice.revolutions)
            .arg(Names::significant(choice.sourcesRms_um, 2),
                 Names::significant(choice.thresholdRms_um, 2));
    return choice.revolutionsMore
               ? found + u' '
                     + tr("A spark-out longer by %1 revolutions would separate them.")
                           .arg(*choice.revolutionsMore)
               : found;
}

QString FitWords::lack(const Project& project, const FitResiduals& residuals) {
    if (!residuals.lack.isLacking()) {
        return {};
    }
    const QString unlike = worded(wordsOf(residuals.unlike.kind));
    return tr("Does not fit: %1: residuals %2 times the noise; by chance up to %3: %4.")
        .arg(group(project, residuals), Names::significant(residuals.lack.ratio, 2),
             Names::fixed(residuals.lack.most, 1),
             residuals.unlike.stage < 0
                 ? unlike
                 : tr("%1 (stage %2)").arg(unlike).arg(residuals.unlike.stage + 1));
}

QString FitWords::unusual(const Project& project, const FittedValue& value) {
    const FittedKind kind = value.parameter.kind;
    return value.isUsual() ? QString()
                           : tr("Does not fit: %1: %2; usual: %3.")
                                 .arg(parameter(project, value.parameter),
                                      (number(kind, value.value) + u' ' + unit(kind)).trimmed(),
                                      interval(kind, value.usual.value_or(Interval())));
}

QString FitWords::overRange(const Project& project, const FitResiduals& residuals) {
    QStringList readings;
    for (const TraceReading& one : residuals.overRange) {
        readings << tr("%1 %2 at %3 s", "a reading, its unit, its time")
                        .arg(number(one.value), unit(residuals.source), number(one.time_s));
    }
    return readings.isEmpty()
               ? QString()
               : tr("Over range: %1: %2: %3.")
                     .arg(group(project, residuals), readings.join(QStringLiteral(", ")),
                          QCoreApplication::translate("Measured", overRangeAdvice()));
}

QString FitWords::unidentified(const Project& project, const std::vector<FittedParameter>& list,
                               const Unidentified& one) {
    QStringList names;
    for (const std::size_t i : one.parameters) {
        names << parameter(project, list.at(i));
    }
    const QString all = names.join(QStringLiteral("; "));
    return one.isProduct ? tr("The data determine only the product: %1. What would help: %2.")
                               .arg(all, advice(one.advice))
           : names.size() > 1 ? tr("The data do not separate: %1. What would help: %2.")
                                    .arg(all, advice(one.advice))
                              : tr("The data do not determine: %1. What would help: %2.")
                                    .arg(all, advice(one.advice));
}

QString FitWords::number(double value) {
    constexpr int digits = 4;
    return printedNumber(value, digits);
}

QString FitWords::number(FittedKind kind, double value) {
    constexpr int decimals = 4;
    return kind == FittedKind::gauge_setting ? Names::fixed(value, decimals) : number(value);
}

QString FitWords::interval(FittedKind kind, const Interval& interval) {
    return number(kind, interval.low) + u'…' + number(kind, interval.high);
}

QString FitWords::interval(const Interval& interval) {
    return number(interval.low) + u'…' + number(interval.high);
}

std::string FitWords::data(const Project& project, const std::vector<int>& traces, bool withParts) {
    QStringList names;
    if (project.measured) {
        for (const int i : traces) {
            const auto at = static_cast<std::size_t>(i);
            if (i < 0 || at >= project.measured->traces.size()) {
                continue;
            }
            const MeasuredTrace& one = project.measured->traces[at];
            const QString name = one.source.empty() ? source(sourceOf(one.quantity))
                                                    : QString::fromStdString(one.source);
            if (!names.contains(name)) {
                names << name;
            }
        }
        if (withParts) {
            names << tr("%n measured part(s)", nullptr, static_cast<int>(partsMeasured(project)));
        }
    }
    constexpr qsizetype most = 120;
    const QString all = names.join(QStringLiteral(", "));
    return (all.size() > most ? all.left(most) + u'…' : all).toStdString();
}

FitTable::FitTable(const QString& name, QWidget* parent)
    : CopyTable([this] { return text(); }, parent), m_model(new QStandardItemModel(this)) {
    setAccessibleName(name);
    setModel(m_model);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setWordWrap(false);
    verticalHeader()->setVisible(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    CopyTable::retranslate();
    connect(this, &CopyTable::resized, this, &FitTable::fitHeight);
}

void FitTable::setCells(const QStringList& head, const std::vector<QStringList>& rows) {
    m_model->clear();
    m_model->setHorizontalHeaderLabels(head);
    for (const QStringList& cells : rows) {
        QList<QStandardItem*> items;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            auto* item = new QStandardItem(cells[i]);
            item->setTextAlignment((i == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            items << item;
        }
        m_model->appendRow(items);
    }
    fitHeight();
}

void FitTable::fitHeight() {
    int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth()
                 + horizontalScrollBar()->sizeHint().height();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        height += rowHeight(row);
    }
    setFixedHeight(height);
}

QString FitTable::text() const {
    QString lines;
    for (int row = -1; row < m_model->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < m_model->columnCount(); ++column) {
            cells << (row < 0 ? m_model->headerData(column, Qt::Horizontal).toString()
                              : m_model->index(row, column).data().toString());
        }
        lines += cells.join(u'\t') + u'\n';
    }
    return lines;
}

} // namespace sparkout
