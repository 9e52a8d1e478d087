// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/bar_chart.h"

#include "ui/chart/view_plot.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

struct BarWords {
    Q_DECLARE_TR_FUNCTIONS(BarChart)
public:
    static std::array<QString, 5> ofBox() {
        return {tr("minimum"), tr("lower quartile"), tr("median"), tr("upper quartile"),
                tr("maximum")};
    }
};

std::array<double, 5> valuesOf(const BarBox& box) {
    return {box.least, box.low, box.median, box.high, box.most};
}

QString nameWithUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit);
}

CsvCell numberCell(double value) {
    return std::isfinite(value) ? CsvCell(value) : CsvCell();
}

} // namespace

BarColour barColour(Tone which) {
    return [which](const QPalette& palette) { return tone(which, palette); };
}

BarColour barColour(style::Drawn what) {
    return [what](const QPalette& palette) { return style::colour(what, palette); };
}

QString BarChart::axisText() const {
    return nameWithUnit(axis, unit);
}

QString BarChart::secondAxisText() const {
    return nameWithUnit(secondAxis, secondUnit);
}

QString BarChart::numberText(double value, bool onSecond) const {
    const Number& text = onSecond ? secondNumber : number;
    return text ? text(value) : Names::significant(value);
}

void BarChart::fitTimeUnit() {
    double longest_s = 0;
    for (const BarLimit& limit : limits) {
        longest_s = std::max(longest_s, limit.at);
    }
    for (std::size_t category = 0; category < static_cast<std::size_t>(categories.size());
         ++category) {
        for (std::size_t i = 0; i < series.size(); ++i) {
            const double time_s = shape == Shape::stacked ? total(category) : value(i, category);
            longest_s = series[i].onSecond ? longest_s : std::fmax(longest_s, time_s);
        }
    }
    const TimeUnit fitting(longest_s);
    unit = fitting.text();
    for (BarLimit& limit : limits) {
        limit.at = fitting.of(limit.at);
    }
    for (BarSeries& bars : series) {
        for (double& value : bars.values) {
            value = bars.onSecond ? value : fitting.of(value);
        }
    }
}

QString BarChart::valueText(std::size_t of, std::size_t category) const {
    const QString text = numberText(value(of, category), series[of].onSecond);
    return series[of].atLeast ? QStringLiteral("≥\u00a0") + text : text;
}

bool BarChart::isLowerBound(std::size_t category) const {
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i].atLeast && std::isfinite(value(i, category))) {
            return true;
        }
    }
    return false;
}

const BarColour& BarChart::colourOfBox(std::size_t category) const {
    return boxKinds.empty() ? boxColour : boxKinds.at(boxes[category].kind).colour;
}

double BarChart::value(std::size_t of, std::size_t category) const {
    const std::vector<double>& values = series[of].values;
    return category < values.size() ? values[category] : std::numeric_limits<double>::quiet_NaN();
}

double BarChart::total(std::size_t category) const {
    double sum = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const double part = value(i, category);
        sum += std::isfinite(part) ? part : 0;
    }
    return sum;
}

// --- words --------------------------------------------------------------------------------------

QString BarChart::described(std::size_t of, std::size_t category) const {
    QString name = categories[static_cast<qsizetype>(category)];
    name.replace(u'\n', u' ');
    if (shape == Shape::boxes) {
        const auto names = BarWords::ofBox();
        const auto values = valuesOf(boxes[category]);
        QStringList texts;
        for (std::size_t i = 0; i < names.size(); ++i) {
            texts << QStringLiteral("%1 %2").arg(names[i], numberText(values[i]));
        }
        return QStringLiteral("%1: %2\u00a0%3")
            .arg(name, texts.join(QStringLiteral(", ")), unit)
            .trimmed();
    }
    const BarSeries& bars = series[of];
    const QString second =
        bars.onSecond ? secondNames.value(static_cast<qsizetype>(category)) : QString();
    const QString part = partName           ? partName(of, category)
                         : second.isEmpty() ? bars.name
                                            : QStringLiteral("%1 (%2)").arg(bars.name, second);
    const QString who = shape == Shape::ring ? part
                        : part.isEmpty()     ? name
                                             : QStringLiteral("%1, %2").arg(name, part);
    return QStringLiteral("%1: %2\u00a0%3")
        .arg(who, valueText(of, category), bars.onSecond ? secondUnit : unit)
        .trimmed();
}

QString BarChart::description() const {
    QStringList lines;
    for (std::size_t category = 0; category < static_cast<std::size_t>(categories.size());
         ++category) {
        if (shape == Shape::boxes) {
            lines << described(0, category);
        }
        for (std::size_t i = 0; i < series.size(); ++i) {
            const double part = value(i, category);
            if (std::isfinite(part) && (part != 0 || series.size() == 1)) {
                lines << described(i, category);
            }
        }
    }
    return lines.join(QStringLiteral("; "));
}

CsvTable BarChart::table(const std::function<bool(std::size_t)>& shows) const {
    CsvTable table;
    table.header << what;
    if (shape == Shape::boxes) {
        for (const QString& name : BarWords::ofBox()) {
            table.header << nameWithUnit(QStringLiteral("%1: %2").arg(axis, name), unit);
        }
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
        const BarSeries& bars = series[i];
        const QString& of = bars.onSecond ? secondAxis : axis;
        if (shows(i)) {
            table.header << nameWithUnit(bars.name.isEmpty() || bars.name == of
                                             ? of
                                             : QStringLiteral("%1: %2").arg(of, bars.name),
                                         bars.onSecond ? secondUnit : unit);
        }
    }
    if (!sums.empty()) {
        table.header << nameWithUnit(QStringLiteral("%1: %2").arg(axis, sumName), unit);
    }
    if (!secondOf.isEmpty()) {
        table.header << secondOf;
    }
    for (std::size_t category = 0; category < static_cast<std::size_t>(categories.size());
         ++category) {
        QString name = categories[static_cast<qsizetype>(category)];
        std::vector<CsvCell> row{name.replace(u'\n', u' ')};
        if (shape == Shape::boxes) {
            for (const double of : valuesOf(boxes[category])) {
                row.push_back(numberCell(of));
            }
        }
        for (std::size_t i = 0; i < series.size(); ++i) {
            if (shows(i)) {
                row.push_back(numberCell(value(i, category)));
            }
        }
        if (!sums.empty()) {
            row.push_back(numberCell(sums[category]));
        }
        if (!secondOf.isEmpty()) {
            row.emplace_back(secondNames.value(static_cast<qsizetype>(category)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

LegendEntries BarChart::legend(const QPalette& palette, bool isDimmed,
                               const std::function<bool(std::size_t)>& shows) const {
    LegendEntries entries;
    const auto entry = [&](const QColor& colour, Qt::PenStyle pen, const QString& name) {
        LegendEntry made;
        made.colour = style::dimmed(colour, isDimmed);
        made.pen = pen;
        made.text = name;
        return made;
    };
    const bool isChosen = series.size() > 1 && shape != Shape::ring;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const BarSeries& bars = series[i];
        if (bars.name.isEmpty()) {
            continue;
        }
        LegendEntry made = entry(bars.colour(palette), Qt::NoPen,
                                 shape == Shape::ring ? described(i, 0)
                                 : bars.onSecond      ? nameWithUnit(bars.name, secondUnit)
                                                      : bars.name);
        made.hatch = bars.hatch;
        made.hatchLine = palette.color(QPalette::Base);
        made.key = isChosen ? static_cast<int>(i) : -1;
        made.shown = !isChosen || shows(i);
        entries.push_back(std::move(made));
    }
    for (const BoxKind& kind : boxKinds) {
        entries.push_back(entry(kind.colour(palette), Qt::NoPen, kind.name));
    }
    const QColor ink = palette.color(QPalette::Text);
    if (!sums.empty()) {
        entries.push_back(entry(ink, Qt::SolidLine, sumName));
    }
    if (band) {
        QColor field = style::colour(style::Drawn::toleranceField, palette);
        field.setAlphaF(0.35F);
        entries.push_back(entry(field, Qt::NoPen, band->name));
    }
    for (const BarLimit& limit : limits) {
        entries.push_back(entry(limit.colour ? limit.colour(palette) : ink, limit.pen, limit.name));
    }
    return entries;
}

} // namespace sparkout
