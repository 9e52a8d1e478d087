// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/batch_figures.h"

#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr double lowOrder = 0.00135, highOrder = 0.99865; ///< ±3s of a normal quantity

const Percentile* percentileOf(const CharacteristicSummary& summary, double order) {
    const auto found = std::ranges::find(summary.percentiles, order, &Percentile::order);
    return found == summary.percentiles.end() ? nullptr : &*found;
}

CsvCell cellOf(const std::optional<double>& value) {
    return value ? CsvCell(*value) : CsvCell();
}

void addInterval(std::vector<CsvCell>& row, const std::optional<Interval>& interval) {
    row.push_back(interval ? CsvCell(interval->low) : CsvCell());
    row.push_back(interval ? CsvCell(interval->high) : CsvCell());
}

void addCapability(std::vector<CsvCell>& row, const std::optional<Capability>& capability) {
    row.push_back(capability ? CsvCell(capability->value) : CsvCell());
    addInterval(row, capability ? std::optional(capability->interval) : std::nullopt);
}

/// Moments, percentiles and capability, empty of corners, which are no sample.
void addEstimates(std::vector<CsvCell>& row, const CharacteristicSummary& summary) {
    const bool known = summary.mean95.has_value();
    const Moments& m = summary.moments;
    for (const double value : {m.mean, m.deviation, m.skewness, m.excess}) {
        row.push_back(known ? CsvCell(value) : CsvCell());
    }
    addInterval(row, summary.mean95);
    row.push_back(summary.normality ? CsvCell(summary.normality->probability) : CsvCell());
    row.push_back(summary.normality ? CsvCell(BatchText::test(summary.normality->test))
                                    : CsvCell());
    addCapability(row, summary.pp);
    addCapability(row, summary.ppk);
}

} // namespace

void BatchFigures::show(BatchOutcomePtr outcome, const std::string& name) {
    beginResetModel();
    m_outcome = std::move(outcome);
    m_places = m_outcome ? placesOf(m_outcome->summary, name) : std::vector<std::size_t>();
    endResetModel();
}

const CharacteristicSummary& BatchFigures::at(int column) const {
    return m_outcome->summary.characteristics[m_places[static_cast<std::size_t>(column)]];
}

QString BatchFigures::text(const CharacteristicSummary& summary, bool isSample, int row) {
    const Characteristic& of = summary.characteristic;
    const auto value = [&of](double v) { return BatchText::value(v, of); };
    const auto percentile = [&](double order) {
        const Percentile* found = isSample ? percentileOf(summary, order) : nullptr;
        return found ? BatchText::percentile(*found, summary) : QStringLiteral("–");
    };
    const bool counted = summary.count > 0;
    const bool estimated = counted && summary.mean95.has_value();
    switch (row) {
    case least: return counted ? value(summary.least.value) : QStringLiteral("–");
    case most: return counted ? value(summary.most.value) : QStringLiteral("–");
    case mean: return estimated ? value(summary.moments.mean) : QStringLiteral("–");
    case meanInterval:
        return estimated ? BatchText::range(*summary.mean95, of) : QStringLiteral("–");
    case deviation:
        return estimated ? BatchText::scatter(summary.moments.deviation, of) : QStringLiteral("–");
    case lowPercentile: return percentile(lowOrder);
    case median: return percentile(0.5);
    case highPercentile: return percentile(highOrder);
    case pp: return BatchText::capability(summary.pp);
    case ppk: return BatchText::capability(summary.ppk);
    case outside:
        return counted && (of.low || of.high) ? BatchText::share(summary.outside)
                                              : QStringLiteral("–");
    case normality: return BatchText::normality(summary);
    default: return {};
    }
}

QString BatchFigures::shownText(int row, int column) const {
    const bool isIndex = row == meanInterval || row == pp || row == ppk;
    return isIndex && !m_tellsIndices ? QStringLiteral("–")
                                      : text(at(column), m_outcome->summary.isSample, row);
}

QVariant BatchFigures::cell(int row, int column, int role) const {
    switch (role) {
    case Qt::DisplayRole: return shownText(row, column);
    case Qt::TextAlignmentRole: return aligned(true);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2: %3")
            .arg(BatchText::full(at(column).characteristic), side(row, Qt::DisplayRole).toString(),
                 shownText(row, column));
    default: return {};
    }
}

QVariant BatchFigures::head(int column, int role) const {
    return role == Qt::DisplayRole && column < columnsShown()
               ? QVariant(BatchText::where(at(column).characteristic))
               : QVariant();
}

QVariant BatchFigures::side(int row, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(false);
    }
    const bool tip = role == Qt::ToolTipRole;
    if (role != Qt::DisplayRole && !tip) {
        return {};
    }
    switch (row) {
    case least: return tr("Minimum");
    case most: return tr("Maximum");
    case mean: return tr("Mean");
    case meanInterval:
        return tip ? tr("Student's interval: the mean of endlessly many such parts lies in it with "
                        "95 %")
                   : tr("Mean, 95 %");
    case deviation: return tip ? tr("Standard deviation of the sample") : tr("s");
    case lowPercentile:
        return tip ? tr("Below it lie 0.135 % of the parts, as below mean − 3 s of a normal "
                        "quantity; given from 741 parts on")
                         .replace(QStringLiteral("0.135"), QLocale().toString(0.135))
                   : tr("Percentile 0.135 %").replace(u'.', QLocale().decimalPoint());
    case median: return tr("Median");
    case highPercentile:
        return tip ? tr("Above it lie 0.135 % of the parts, as above mean + 3 s of a normal "
                        "quantity; given from 741 parts on")
                         .replace(QStringLiteral("0.135"), QLocale().toString(0.135))
                   : tr("Percentile 99.865 %").replace(u'.', QLocale().decimalPoint());
    case pp:
        return tip ? tr("Width of the field over 6 s, with 95 % bounds; s is that of all parts, "
                        "with whatever drifts over the batch. Where nothing drifts it is Cp")
                   : tr("Pp");
    case ppk:
        return tip ? tr("Distance from the mean to the nearer limit over 3 s, with 95 % bounds; it "
                        "says what it says of a normal quantity. A dash: no size or form of the "
                        "part, or one that hardly scatters beside its field")
                   : tr("Ppk");
    case outside:
        return tip ? tr("Parts beyond the limits, as a share with the 95 % bounds of Clopper and "
                        "Pearson")
                   : tr("Out of tolerance");
    case normality:
        return tip ? tr(
                   "Probability that normal values deviate so much from the normal law, by the "
                   "test of Shapiro and Wilk, of more than 4096 parts of Anderson and "
                   "Darling; below 0.05 the values are called not normal")
               : m_outcome ? BatchText::shortNormalityName(m_outcome->summary)
                           : tr("Normality, p");
    default: return {};
    }
}

CsvTable batchFiguresTable(const BatchSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << BatchFigures::tr("Where") << BatchFigures::tr("Characteristic")
                 << BatchFigures::tr("Unit") << BatchFigures::tr("Lower limit")
                 << BatchFigures::tr("Upper limit") << BatchFigures::tr("Values")
                 << BatchFigures::tr("Minimum") << BatchFigures::tr("Maximum")
                 << BatchFigures::tr("Mean") << BatchFigures::tr("s")
                 << BatchFigures::tr("Skewness") << BatchFigures::tr("Excess kurtosis")
                 << BatchFigures::tr("Mean, 95 % from") << BatchFigures::tr("Mean, 95 % to")
                 << BatchFigures::tr("Normality, p") << BatchFigures::tr("Normality, test")
                 << BatchFigures::tr("Pp") << BatchFigures::tr("Pp, 95 % from")
                 << BatchFigures::tr("Pp, 95 % to") << BatchFigures::tr("Ppk")
                 << BatchFigures::tr("Ppk, 95 % from") << BatchFigures::tr("Ppk, 95 % to")
                 << BatchFigures::tr("Out of tolerance")
                 << BatchFigures::tr("Share out of tolerance")
                 << BatchFigures::tr("Share, 95 % from") << BatchFigures::tr("Share, 95 % to");
    if (summary.isSample && !summary.characteristics.empty()) {
        for (const Percentile& percentile : summary.characteristics.front().percentiles) {
            const QString name = BatchFigures::tr("Percentile %1 %").arg(100 * percentile.order);
            table.header << name << BatchFigures::tr("%1, 95 % from").arg(name)
                         << BatchFigures::tr("%1, 95 % to").arg(name);
        }
    }
    for (const CharacteristicSummary& of : summary.characteristics) {
        const Characteristic& c = of.characteristic;
        std::vector<CsvCell> row{BatchText::where(c), BatchText::name(c),
                                 unitText(c.unit),    cellOf(c.low),
                                 cellOf(c.high),      static_cast<double>(of.count)};
        const bool counted = of.count > 0;
        row.push_back(counted ? CsvCell(of.least.value) : CsvCell());
        row.push_back(counted ? CsvCell(of.most.value) : CsvCell());
        addEstimates(row, of);
        const bool limited = counted && (c.low || c.high);
        row.push_back(limited ? CsvCell(static_cast<double>(of.outside.count)) : CsvCell());
        row.push_back(limited ? CsvCell(of.outside.value) : CsvCell());
        addInterval(row, limited ? of.outside.interval : std::nullopt);
        for (const Percentile& percentile : of.percentiles) {
            if (summary.isSample) {
                row.emplace_back(percentile.value);
                addInterval(row, percentile.interval);
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
