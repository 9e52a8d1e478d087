// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/numbers_editor.h"

#include "ui/inputs/editors/pasted_numbers.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace sparkout {

namespace {

QString joinedNumbers(const std::vector<double>& values) {
    QStringList texts;
    for (const double value : values) {
        texts += showNumber(value, QLocale());
    }
    return texts.join(QStringLiteral("; "));
}

/// "from…to step s", written in either language, with … or dots or a dash between.
std::optional<SteppedLevels> steppedIn(const QString& text) {
    static const QRegularExpression pattern(
        QStringLiteral(R"(^\s*(\S+?)\s*(?:…|\.{2,3}|–|\s-\s|\sto\s|\sдо\s)\s*(\S+?))"
                       R"(\s*(?:;|:|/|,\s|step|шаг|in steps of|шагом|с шагом)\s*(\S+)\s*$)"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch found = pattern.match(text);
    const auto from = parseNumber(found.captured(1)), to = parseNumber(found.captured(2)),
               step = parseNumber(found.captured(3));
    return found.hasMatch() && from && to && step ? std::optional(SteppedLevels{*from, *to, *step})
                                                  : std::nullopt;
}

} // namespace

Levels NumbersEditor::stored() const {
    switch (field().kind) {
    case Kind::numberList: return field().as<std::vector<double>>(owner());
    case Kind::optionalNumberList: {
        const auto& list = field().as<std::optional<std::vector<double>>>(owner());
        return list ? Levels(*list) : Levels();
    }
    default: return field().as<Levels>(owner());
    }
}

void NumbersEditor::put(const Levels& levels, void* to) const {
    const auto* list = std::get_if<std::vector<double>>(&levels);
    switch (field().kind) {
    case Kind::numberList: field().as<std::vector<double>>(to) = *list; break;
    case Kind::optionalNumberList:
        field().as<std::optional<std::vector<double>>>(to) =
            list ? std::optional(*list) : std::nullopt;
        break;
    default: field().as<Levels>(to) = levels;
    }
}

QString NumbersEditor::storedText() const {
    const Levels levels = stored();
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        return tr("%1…%2 step %3")
            .arg(showNumber(stepped->from, QLocale()), showNumber(stepped->to, QLocale()),
                 showNumber(stepped->step, QLocale()));
    }
    const auto* list = std::get_if<std::vector<double>>(&levels);
    return list ? joinedNumbers(*list) : QString();
}

std::optional<Levels> NumbersEditor::read(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return field().kind == Kind::numberList ? std::nullopt : std::optional(Levels());
    }
    if (field().kind == Kind::levels) {
        if (const auto stepped = steppedIn(text)) {
            return Levels(*stepped);
        }
    }
    std::vector<double> list;
    for (const QString& part : text.split(u';', Qt::SkipEmptyParts)) {
        const std::optional<double> value = parseNumber(part);
        if (!value) {
            return std::nullopt;
        }
        list.push_back(*value);
    }
    return field().count > 0 && list.size() != field().count ? std::nullopt
                                                             : std::optional(Levels(list));
}

bool NumbersEditor::isStored(const QString& text) const {
    const std::optional<Levels> read = this->read(text);
    return read && *read == stored();
}

QString NumbersEditor::grammar() const {
    if (field().kind == Kind::levels) {
        return tr("values separated by semicolons, as in 300; 500; 800, or from, to and step, as "
                  "in 300…2400 step 100");
    }
    return field().count > 0 ? tr("%n number(s) separated by semicolons", nullptr,
                                  static_cast<int>(field().count))
                             : tr("numbers separated by semicolons, as in 1; 2; 3");
}

QString NumbersEditor::fault(const Levels& levels) const {
    std::vector<double> values;
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        if (stepped->to < stepped->from) {
            return tr("the second value is below the first");
        }
        values = {stepped->from, stepped->to, stepped->step};
    } else if (const auto* list = std::get_if<std::vector<double>>(&levels)) {
        values = *list;
    }
    const Range& range = field().stated();
    const auto outside =
        std::ranges::find_if(values, [&range](double value) { return !range.contains(value); });
    if (outside != values.end()) {
        return tr("%1: allowed is %2")
            .arg(printedNumber(*outside), rangeShown(range, field().unit));
    }
    return fits([this, &levels](void* to) { put(levels, to); })
               ? QString()
               : tr("the other inputs do not go with these values");
}

NumbersEditor::CellsText NumbersEditor::textOf(const PastedCells& cells) const {
    const PastedNumbers numbers(cells, field().stated(), field().unit);
    return {joinedNumbers(numbers.inOrder()), numbers.fault()};
}

QString NumbersEditor::accept(const QString& text) {
    const std::optional<Levels> levels = read(text);
    if (!levels) {
        return grammar();
    }
    const QString reason = fault(*levels);
    if (reason.isEmpty()) {
        change([this, &levels](void* to) { put(*levels, to); });
    }
    return reason;
}

} // namespace sparkout
