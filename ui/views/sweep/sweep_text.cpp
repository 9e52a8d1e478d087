// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_text.h"

#include "core/quality/constraints.h"
#include "ui/plot/run_bar.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int mostNamed = 3; ///< requirements named at a point
constexpr int sweepDigits = 4;

QString withUnit(const QString& text, const std::string& unit, const QString& between) {
    return unit.empty() ? text : text + between + unitText(unit.c_str());
}

QString amount(double value, const std::string& unit) {
    return withUnit(Names::significant(value, sweepDigits), unit, QStringLiteral("\u00a0"));
}

} // namespace

/// The page, list item and input of a path, without the levels between them.
QString SweepText::input(const std::string& path) {
    const QStringList words = locationText(path).split(QStringLiteral(" › "));
    QStringList kept;
    for (const QString& word : words) {
        if (&word == &words.front() || &word == &words.back() || word.back().isDigit()) {
            kept << word;
        }
    }
    if (path.starts_with("/cycle/stages/")) {
        kept.removeFirst();
    }
    return kept.join(QStringLiteral(" › "));
}

QString SweepText::inputBrief(const std::string& path) {
    const QStringList words = locationText(path).split(QStringLiteral(" › "));
    const bool stage = path.starts_with("/cycle/stages/") && words.size() > 1;
    const bool part = path.starts_with("/machine/") && words.size() > 2;
    return stage || part ? words.mid(words.size() - 2).join(QStringLiteral(" › ")) : words.last();
}

QString SweepText::inputAxis(const SweptInput& input) {
    return withUnit(inputBrief(input.axis.input), input.unit, QStringLiteral(", "));
}

QString SweepText::inputValue(double value, const SweptInput& input) {
    return withUnit(printedNumber(ShownScale::at(input.axis.input).shown(value)), input.unit,
                    QStringLiteral(" "));
}

QString SweepText::name(const SweepQuantity& quantity) {
    if (const Requirement* const row = requirementNamed(quantity.name)) {
        return Names::constraint(row->kind);
    }
    return quantity.name == "time"                ? tr("Machining time")
           : quantity.name == "least_margin"      ? tr("Minimum margin of all requirements")
           : quantity.name == "diameter"          ? tr("Mean diameter")
           : quantity.name == "peak_normal_force" ? tr("Maximum normal force")
                                                  : tr("Maximum power");
}

QString SweepText::where(const SweepQuantity& quantity) {
    return quantity.section < 0 ? tr("whole part") : Names::zone(quantity.zone, quantity.section);
}

QString SweepText::entry(const SweepResult& sweep, const SweepEntry& entry) {
    const SweepQuantity& first = sweep.quantities[entry.quantities.front()];
    return entry.key == first.name || first.section < 0
               ? name(first)
               : QStringLiteral("%1, %2").arg(name(first), Names::within(where(first)));
}

QString SweepText::axis(const SweepResult& sweep, const SweepEntry& entry, bool margins) {
    const QString of = SweepText::entry(sweep, entry);
    return withUnit(margins ? tr("Margin: %1").arg(of) : of,
                    sweep.quantities[entry.quantities.front()].unit, QStringLiteral(", "));
}

QString SweepText::column(const SweepQuantity& quantity) {
    const QString of = quantity.section < 0
                           ? name(quantity)
                           : QStringLiteral("%1, %2").arg(name(quantity), where(quantity));
    return withUnit(of, quantity.unit, QStringLiteral(", "));
}

QString SweepText::status(const SweepPoint& point) {
    switch (point.status) {
    case SweepStatus::pending: return tr("not run");
    case SweepStatus::refused: return tr("refused");
    case SweepStatus::notReached: return tr("does not reach size");
    case SweepStatus::done: break;
    }
    return point.good ? tr("fit") : tr("unfit");
}

QString SweepText::progress(qint64 done, qint64 points, double left_s) {
    return RunBar::withTimeLeft(tr("%1 of %2 points").arg(done).arg(points), left_s);
}

QString SweepText::run(const SweepResult& sweep) {
    const auto count = [&sweep](SweepStatus status) {
        return static_cast<int>(std::ranges::count(sweep.points, status, &SweepPoint::status));
    };
    const int good = static_cast<int>(std::ranges::count(sweep.points, true, &SweepPoint::good));
    const int all = static_cast<int>(sweep.points.size());
    QStringList texts;
    if (sweep.stopped) {
        texts
            << tr("Stopped after %1 of %2 points.").arg(all - count(SweepStatus::pending)).arg(all);
    }
    texts << tr("%1 of %2 points meet the drawing.").arg(good).arg(all);
    if (const int refused = count(SweepStatus::refused)) {
        texts << tr("Refused: %1.").arg(refused);
    }
    if (const int stuck = count(SweepStatus::notReached)) {
        texts << tr("Size not reached: %1.").arg(stuck);
    }
    return texts.join(u' ');
}

QString SweepText::inputs(const SweepResult& sweep, std::size_t point) {
    QStringList texts;
    const std::vector<double> values = sweep.valuesAt(point);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SweptInput& input = sweep.inputs[i];
        texts << inputBrief(input.axis.input) + u' ' + inputValue(values[i], input);
    }
    return texts.join(QStringLiteral(", "));
}

/// Whether the drawing is met, and what violates it.
QString SweepText::verdict(const SweepResult& sweep, const SweepPoint& point) {
    if (point.good) {
        return tr("all requirements are met");
    }
    QStringList failing;
    for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
        const SweepQuantity& quantity = sweep.quantities[q];
        if (requirementNamed(quantity.name) && point.values[q].margin < 0) {
            failing << (quantity.section < 0 ? name(quantity)
                                             : name(quantity) + u' ' + where(quantity));
        }
    }
    const bool more = failing.size() > mostNamed;
    return tr("not met: %1")
        .arg(failing.mid(0, mostNamed).join(QStringLiteral(", "))
             + (more ? QStringLiteral(" …") : QString()));
}

QString SweepText::point(const SweepResult& sweep, std::size_t point, const SweepEntry& entry) {
    const SweepPoint& at = sweep.points[point];
    const QString inputs = SweepText::inputs(sweep, point);
    switch (at.status) {
    case SweepStatus::pending: return tr("%1: not run").arg(inputs);
    case SweepStatus::refused:
        return tr("%1: refused. %2").arg(inputs, Names::refusal(at.issues, 1));
    case SweepStatus::notReached: return tr("%1: %2").arg(inputs, Names::status(at.run));
    case SweepStatus::done: break;
    }
    QStringList texts;
    for (const std::size_t q : entry.quantities) {
        const SweepValue& value = at.values[q];
        const SweepQuantity& quantity = sweep.quantities[q];
        if (std::isnan(value.value) || quantity.name == "time") {
            continue;
        }
        QString text = (entry.quantities.size() > 1 ? where(quantity) + u' ' : QString())
                       + amount(value.value, quantity.unit);
        if (!std::isnan(value.margin) && quantity.name != "least_margin") {
            text += tr(" (margin %1)").arg(Names::significant(value.margin, 3));
        }
        texts << text;
    }
    QString shown = texts.join(QStringLiteral(", "));
    shown = shown.isEmpty() ? QString() : SweepText::entry(sweep, entry) + u' ' + shown + u';';
    for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
        if (sweep.quantities[q].name == "time") {
            shown += tr(" time %1;").arg(amount(at.values[q].value, "s"));
        }
    }
    return QStringLiteral("%1: %2 %3").arg(inputs, shown.trimmed(), verdict(sweep, at));
}

} // namespace sparkout
