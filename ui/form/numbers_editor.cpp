// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/numbers_editor.h"

#include "ui/form/pasted_numbers.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

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

NumbersEditor::NumbersEditor(const std::string& path, const Field& field, FormModel& model,
                             QWidget* parent, SpecOf spec)
    : LineEditor(path, field, model, parent), m_spec(spec ? std::move(spec) : SpecOf([&field] {
        NumberSpec own;
        own.hard = field.stated();
        own.unit = field.unit;
        own.optional = field.kind != Kind::numberList;
        return own;
    })) {}

QString NumbersEditor::joined(const std::vector<double>& values) const {
    const ShownScale scale = m_spec().scale;
    QStringList texts;
    for (const double value : values) {
        texts += showNumber(scale.shown(value), QLocale());
    }
    return texts.join(QStringLiteral("; "));
}

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
    return list ? joined(*list) : QString();
}

std::optional<Levels> NumbersEditor::read(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return m_spec().optional ? std::optional(Levels()) : std::nullopt;
    }
    if (field().kind == Kind::levels) {
        if (const auto stepped = steppedIn(text)) {
            return Levels(*stepped);
        }
    }
    const ShownScale scale = m_spec().scale;
    std::vector<double> list;
    for (const QString& part : text.split(u';', Qt::SkipEmptyParts)) {
        const std::optional<double> value = parseNumber(part);
        if (!value) {
            return std::nullopt;
        }
        list.push_back(scale.kept(*value));
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
    const NumberSpec spec = m_spec();
    const auto outside =
        std::ranges::find_if(values, [&spec](double value) { return !spec.hard.contains(value); });
    if (outside != values.end()) {
        return tr("%1: allowed is %2")
            .arg(printedNumber(spec.scale.shown(*outside)),
                 rangeShown(spec.scale.shown(spec.hard), spec.unit));
    }
    return fits([this, &levels](void* to) { put(levels, to); })
               ? QString()
               : tr("the other inputs do not go with these values");
}

NumbersEditor::CellsText NumbersEditor::textOf(const PastedCells& cells) const {
    const NumberSpec spec = m_spec();
    const PastedNumbers numbers(cells, spec.scale.shown(spec.hard), spec.unit);
    std::vector<double> values = numbers.inOrder();
    std::ranges::transform(values, values.begin(),
                           [&spec](double value) { return spec.scale.kept(value); });
    return {joined(values), numbers.fault()};
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
