// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/texts.h"

#include "core/catalogue/catalogue.h"
#include "core/printable.h"
#include "core/project/member.h"
#include "core/project/project.h"
#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "words/issue_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace sparkout {

namespace {

QString translated(const char* context, const char* text) {
    return *text ? QCoreApplication::translate(context, text) : QString();
}

/// Units of the inputs and results, marked for translation.
[[maybe_unused]] constexpr std::array units{
    QT_TRANSLATE_NOOP("Unit", "mm/dbl stroke"),
    QT_TRANSLATE_NOOP("Unit", "mm/min"),
    QT_TRANSLATE_NOOP("Unit", "mm/N"),
    QT_TRANSLATE_NOOP("Unit", "mm²/s"),
    QT_TRANSLATE_NOOP("Unit", "mm"),
    QT_TRANSLATE_NOOP("Unit", "µm"),
    QT_TRANSLATE_NOOP("Unit", "rev/min"),
    QT_TRANSLATE_NOOP("Unit", "m/s"),
    QT_TRANSLATE_NOOP("Unit", "s"),
    QT_TRANSLATE_NOOP("Unit", "N, N/µm"),
    QT_TRANSLATE_NOOP("Unit", "N/µm"),
    QT_TRANSLATE_NOOP("Unit", "MPa"),
    QT_TRANSLATE_NOOP("Unit", "GPa"),
    QT_TRANSLATE_NOOP("Unit", "kW"),
    QT_TRANSLATE_NOOP("Unit", "HRC"),
    QT_TRANSLATE_NOOP("Unit", "W/(m·K)"),
    QT_TRANSLATE_NOOP("Unit", "J/m²"),
    QT_TRANSLATE_NOOP("Unit", "1/mm²"),
    QT_TRANSLATE_NOOP("Unit", "K"),
    QT_TRANSLATE_NOOP("Unit", "°"),
    QT_TRANSLATE_NOOP("Unit", "bytes"),
    QT_TRANSLATE_NOOP("Unit", "tags"),
    QT_TRANSLATE_NOOP("Unit", "nested tags"),
    QT_TRANSLATE_NOOP("Unit", "°C"),
    QT_TRANSLATE_NOOP("Unit", "kg/m³"),
    QT_TRANSLATE_NOOP("Unit", "°C, W/(m·K)"),
    QT_TRANSLATE_NOOP("Unit", "°C, J/(kg·K)"),
    QT_TRANSLATE_NOOP("Unit", "10⁻⁶/K"),
    QT_TRANSLATE_NOOP("Unit", "µm/h"),
    QT_TRANSLATE_NOOP("Unit", "h"),
    QT_TRANSLATE_NOOP("Unit", "kW/A"),
    QT_TRANSLATE_NOOP("Unit", "kg"),
    QT_TRANSLATE_NOOP("Unit", "g·mm"),
    QT_TRANSLATE_NOOP("Unit", "Hz"),
    QT_TRANSLATE_NOOP("Unit", "1/mm"),
};

/// "L_p" → "Lₚ", if there are characters for the whole index.
QString withSubscripts(QString text) {
    static const QString plain = QStringLiteral("0123456789aehijklmnoprstuvx");
    static const QString below = QStringLiteral("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ");
    for (qsizetype from = text.indexOf(u'_'); from >= 0; from = text.indexOf(u'_', from + 1)) {
        QString index;
        qsizetype end = from + 1;
        for (; end < text.size() && text[end].isLetterOrNumber(); ++end) {
            const qsizetype at = plain.indexOf(text[end]);
            index += at < 0 ? QString() : below[at];
        }
        if (index.size() == end - from - 1) {
            text.replace(from, end - from, index);
        }
    }
    return text;
}

/// Issues in the current language, with the window's number format and names.
class WindowWording : public Wording {
protected:
    std::string translated(const char* context, const std::string& text) const override {
        return sparkout::translated(context, text.c_str()).toStdString();
    }
    std::string number(double value) const override { return printedNumber(value).toStdString(); }
    std::string numeral(const std::string& digits) const override {
        return withMinus(
            withPower(QString::fromStdString(digits)).replace(u'.', QLocale().decimalPoint()));
    }
    std::string input(const std::string& path) const override {
        const Field& field = *nearestField(Project(), path);
        return QStringLiteral("%1 %2")
            .arg(inputText(field.label), withSubscripts(QString::fromUtf8(field.symbol)))
            .trimmed()
            .toStdString();
    }
    std::string formula(const std::string& letters) const override {
        return withSubscripts(QString::fromStdString(letters)).toStdString();
    }

private:
    static std::string withMinus(QString number) {
        if (number.startsWith(u'-')) {
            number[0] = u'−';
        }
        return number.toStdString();
    }
};

} // namespace

QString inputText(const char* text) {
    return translated("Input", text);
}
QString choiceText(const char* text) {
    return translated("Choice", text);
}
QString requirementText(const char* text) {
    return translated("Requirement", text);
}
QString structText(const char* text) {
    return translated("Struct", text);
}
QString unitText(const char* unit) {
    return translated("Unit", unit);
}

QString zoneText(const char* key) {
    const QLatin1StringView name(key);
    if (name == QLatin1StringView("rz1")) {
        return QCoreApplication::translate("Zone", "RZ1");
    }
    if (name == QLatin1StringView("nz")) {
        return QCoreApplication::translate("Zone", "NZ");
    }
    return name == QLatin1StringView("rz2") ? QCoreApplication::translate("Zone", "RZ2")
                                            : QString::fromUtf8(key);
}

QString rangeShown(const Range& range, const char* unit) {
    const bool below = std::isfinite(range.low);
    const bool above = std::isfinite(range.high);
    const QString low = printedNumber(range.low);
    const QString high = printedNumber(range.high);
    QString text;
    if (below && above) {
        text = range.lowOpen ? QCoreApplication::translate("Range", "above %1, up to %2")
                             : QCoreApplication::translate("Range", "%1 to %2");
        text = text.arg(low, high);
    } else if (below) {
        text = range.lowOpen ? QCoreApplication::translate("Range", "above %1").arg(low)
                             : QCoreApplication::translate("Range", "at least %1").arg(low);
    } else if (above) {
        text = QCoreApplication::translate("Range", "at most %1").arg(high);
    }
    return text.isEmpty() || !*unit ? text : text + u'\u00a0' + unitText(unit);
}

QString rangeBrief(const Range& range, const char* unit) {
    const auto number = [](double value) { return printedNumber(value); };
    QString text;
    if (std::isfinite(range.low)) {
        text = (range.lowOpen ? QStringLiteral(">") : QString()) + number(range.low);
        text.prepend(std::isfinite(range.high) || range.lowOpen ? QString() : QStringLiteral("≥"));
    }
    if (std::isfinite(range.high)) {
        text += (text.isEmpty() ? QStringLiteral("≤") : QStringLiteral("…")) + number(range.high);
    }
    return text.isEmpty() || !*unit ? text : text + u'\u00a0' + unitText(unit);
}

QString issueText(const Issue& issue) {
    const ShownScale scale = ShownScale::of(issue);
    const QString text =
        fileIssueText({issue.code, issue.severity, issue.path, scale.shown(issue.value),
                       scale.shown(issue.limit), issue.wheel});
    return scale.factor == 1
               ? text
               : QCoreApplication::translate("Issue", "%1 (stock on diameter)").arg(text);
}

QString fileIssueText(const Issue& issue) {
    return QString::fromStdString(WindowWording().sentence(issue));
}

namespace {

/// An entry besides the surfaces in the file of a set-up.
struct SetupPart {
    const char* key;
    const StructInfo& (*table)();
};

const SetupPart* setupPart(const QString& key) {
    static constexpr SetupPart parts[] = {{"times", tableOf<SetupTimes>},
                                          {"wear", tableOf<WheelWear>}};
    const auto* const found = std::ranges::find_if(
        parts, [&key](const SetupPart& part) { return key == QLatin1StringView(part.key); });
    return found == std::end(parts) ? nullptr : found;
}

QString location(const std::string& path, QString (*label)(const Field&)) {
    QStringList words;
    const StructInfo* table = &tableOf<Project>();
    const Field* list = nullptr;
    QStringList keys = QString::fromStdString(path).split(u'/', Qt::SkipEmptyParts);
    if (keys.size() > 1 && keys.front() == u"surfaces") { // of a file of several
        words += QCoreApplication::translate("Location", "Surface %1").arg(keys[1].toInt() + 1);
        keys.remove(0, 2);
    }
    for (const QString& key : keys) {
        bool isIndex = false;
        const int index = key.toInt(&isIndex);
        const Field* field = table ? table->find(key.toStdString()) : nullptr;
        if (const SetupPart* part = words.isEmpty() ? setupPart(key) : nullptr) {
            words += structText(part->table().name);
            table = &part->table();
        } else if (isIndex && list && list->nested) {
            words += QCoreApplication::translate("Location", "%1 %2")
                         .arg(structText(list->nested->name))
                         .arg(index + 1);
        } else if (isIndex && list && list->kind == Kind::compliance) {
            words += QCoreApplication::translate("Zone", "Section %1").arg(index + 1);
        } else if (field) {
            words += label(*field);
            table = field->nested;
            list = field;
        } else {
            words += zoneText(key.toUtf8().constData());
        }
    }
    return words.join(QStringLiteral(" › "));
}

} // namespace

QString locationText(const std::string& path) {
    return location(path, [](const Field& field) { return inputText(field.label); });
}

QString inputLocation(const std::string& path) {
    return location(path, StockReading::label);
}

QString printableText(const QString& text) {
    return QString::fromStdString(printable(text.toStdString()));
}

QString harmlessText(QString text) {
    for (QChar& c : text) {
        const bool control = (c < u' ' && c != u'\n' && c != u'\t' && c != u'\r')
                             || (c >= QChar(0x7f) && c < QChar(0xa0));
        const bool turns = c == QChar(0x061c) || c == QChar(0x200e) || c == QChar(0x200f)
                           || (c >= QChar(0x202a) && c <= QChar(0x202e))
                           || (c >= QChar(0x2066) && c <= QChar(0x2069));
        if (control || turns || c.isNonCharacter()) {
            c = QChar::ReplacementCharacter;
        }
    }
    return text;
}

QString unbroken(QString text) {
    return text.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"))
        .replace(QStringLiteral(" ± "), QStringLiteral("\u00a0±\u00a0"));
}

QString withIndices(const QString& text) {
    static const QRegularExpression index(QStringLiteral("_(?:\\(([^)]*)\\)|(\\w+))"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    return text.toHtmlEscaped().replace(index, QStringLiteral("<sub>\\1\\2</sub>"));
}

namespace {

struct SourceName {
    std::string_view key; ///< key in core/SOURCES.md
    const char* text;
};

constexpr std::array names{
    SourceName{"MODEL-1", QT_TRANSLATE_NOOP("Source", "model page, section 1: symbols and units")},
    SourceName{"MODEL-2", QT_TRANSLATE_NOOP("Source", "model page, section 2: the force law")},
    SourceName{"MODEL-3", QT_TRANSLATE_NOOP("Source", "model page, section 3: elastic balance")},
    SourceName{"MODEL-4", QT_TRANSLATE_NOOP("Source", "model page, section 4: blank and profile")},
    SourceName{"MODEL-5", QT_TRANSLATE_NOOP("Source", "model page, section 5: traverse cycle")},
    SourceName{"MODEL-6", QT_TRANSLATE_NOOP("Source", "model page, section 6: plunge cycle and "
                                                      "compliance along the shaft")},
    SourceName{"MODEL-7", QT_TRANSLATE_NOOP("Source", "model page, section 7: control, end of the "
                                                      "cycle, accuracy")},
    SourceName{"MODEL-8", QT_TRANSLATE_NOOP("Source", "model page, section 8: constraints, batch, "
                                                      "optimisation")},
    SourceName{"MODEL-9", QT_TRANSLATE_NOOP("Source", "model page, section 9: misprints in the "
                                                      "sources")},
    SourceName{"MODEL-10", QT_TRANSLATE_NOOP("Source", "model page, section 10: published "
                                                       "figures")},
    SourceName{"MODEL-11", QT_TRANSLATE_NOOP("Source", "model page, section 11: exact "
                                                       "properties")},
    SourceName{"MODEL-12", QT_TRANSLATE_NOOP("Source", "model page, section 12: several surfaces "
                                                       "in one set-up")},
    SourceName{"MODEL-16", QT_TRANSLATE_NOOP("Source", "model page, section 16: waves of the "
                                                       "wheel")},
    SourceName{"ALSIGAR2021", QT_TRANSLATE_NOOP("Source", "M. K. Alsigar, thesis abstract, Penza, "
                                                          "2021")},
    SourceName{"PEREVERZEV1999", QT_TRANSLATE_NOOP("Source", "P. P. Pereverzev, doctoral thesis "
                                                             "abstract, Chelyabinsk, 1999")},
    SourceName{"AKINTSEVA2020", QT_TRANSLATE_NOOP("Source", "A. V. Akintseva, digital twin of "
                                                            "cylindrical grinding, 2020")},
    SourceName{"KORCHAK", QT_TRANSLATE_NOOP("Source", "S. N. Korchak, force of a single grain")},
    SourceName{"ISO12180", QT_TRANSLATE_NOOP("Source", "ISO 12180-1:2011, cylindricity")},
    SourceName{"ISO12181", QT_TRANSLATE_NOOP("Source", "ISO 12181-1:2011, roundness")},
    SourceName{"BADGER2010", QT_TRANSLATE_NOOP("Source", "J. A. Badger, 2010, waviness of ground "
                                                         "parts")},
    SourceName{"ISO286", QT_TRANSLATE_NOOP("Source", "ISO 286-1:2010, tolerance classes")},
    SourceName{"ISO525", QT_TRANSLATE_NOOP("Source", "ISO 525, marking of grinding wheels")},
    SourceName{"GOSTR52781", QT_TRANSLATE_NOOP("Source", "GOST R 52781, grinding wheels")},
    SourceName{"ABRASIVES",
               QT_TRANSLATE_NOOP("Source", "Zaporozhabrasive, marking of abrasive tools")},
    SourceName{"DIN50150", QT_TRANSLATE_NOOP("Source", "DIN 50150, strength and hardness of "
                                                       "steel")},
    SourceName{"SAEJ417", QT_TRANSLATE_NOOP("Source", "SAE J417, strength and hardness of steel")},
    SourceName{"TABOR1951", QT_TRANSLATE_NOOP("Source", "Tabor, 1951, yield stress and hardness")},
    SourceName{"MARKING", QT_TRANSLATE_NOOP("Source", "the marking on the wheel itself")},
    SourceName{"GILBERT1950", QT_TRANSLATE_NOOP("Source", "Gilbert, 1950, economics of machining")},
    SourceName{"HASHIMOTO2020", QT_TRANSLATE_NOOP("Source", "Hashimoto, 2020, contact stiffness "
                                                            "of the wheel")},
    SourceName{"MH31", QT_TRANSLATE_NOOP("Source", "Machinery's Handbook 31, cylindrical "
                                                   "grinding")},
    SourceName{"HON585", QT_TRANSLATE_NOOP("Source", "hon1.ru, spark-out and threshold force")},
    SourceName{"HON174", QT_TRANSLATE_NOOP("Source", "hon1.ru, balancing of grinding wheels")},
    SourceName{"ISO21940", QT_TRANSLATE_NOOP("Source", "ISO 21940-11:2016, grades of balance")},
    SourceName{"AKAIKE1974", QT_TRANSLATE_NOOP("Source", "Akaike, 1974, choice of a model")},
    SourceName{
        "SALMON2011",
        QT_TRANSLATE_NOOP("Source", "Salmon and others, 2011, random numbers from a counter")},
    SourceName{"JOEKUO2008", QT_TRANSLATE_NOOP("Source", "Joe and Kuo, 2008, Sobol sequences")},
    SourceName{"MCKAY1979",
               QT_TRANSLATE_NOOP("Source", "McKay, Beckman and Conover, 1979, Latin hypercube")},
    SourceName{"IMAN1982", QT_TRANSLATE_NOOP("Source", "Iman and Conover, 1982, rank correlation")},
    SourceName{"IMAN1979",
               QT_TRANSLATE_NOOP("Source", "Iman and Conover, 1979, regression of ranks")},
    SourceName{"SALTELLI2010",
               QT_TRANSLATE_NOOP("Source", "Saltelli and others, 2010, Sobol indices")},
    SourceName{"KULISCH2008", QT_TRANSLATE_NOOP("Source", "Kulisch, 2008, exact sums")},
    SourceName{"CLOPPER1934",
               QT_TRANSLATE_NOOP("Source", "Clopper and Pearson, 1934, bounds of a share")},
    SourceName{"KOTZ1993",
               QT_TRANSLATE_NOOP("Source", "Kotz and Johnson, 1993, process capability indices")},
    SourceName{"BISSELL1990", QT_TRANSLATE_NOOP("Source", "Bissell, 1990, bounds of Cpk")},
    SourceName{"FISHER1925", QT_TRANSLATE_NOOP("Source", "Fisher, 1925, test of two variances")},
    SourceName{"WELCH1947", QT_TRANSLATE_NOOP("Source", "Welch, 1947, means of unequal variances")},
    SourceName{"HUBER1981", QT_TRANSLATE_NOOP("Source", "Huber, 1981, robust estimates")},
    SourceName{"FIPS180-4", QT_TRANSLATE_NOOP("Source", "FIPS 180-4, secure hash standard")},
    SourceName{"ISO22514", QT_TRANSLATE_NOOP("Source", "ISO 22514-1, process performance")},
    SourceName{"SHAPIRO1965",
               QT_TRANSLATE_NOOP("Source", "Shapiro and Wilk, 1965, test for normality")},
    SourceName{"ROYSTON1995", QT_TRANSLATE_NOOP("Source", "Royston, 1995, algorithm AS R94 for W")},
    SourceName{"STEPHENS1974",
               QT_TRANSLATE_NOOP("Source", "Stephens, 1974, statistics of goodness of fit")},
    SourceName{"DAGOSTINO1986",
               QT_TRANSLATE_NOOP("Source", "D'Agostino and Stephens, 1986, goodness of fit")},
    SourceName{"FEPA42", QT_TRANSLATE_NOOP("Source", "sizes of F grits after FEPA 42-D-1986")},
    SourceName{"ALORO40X", QT_TRANSLATE_NOOP("Source", "aloro.org, steel 40Х")},
    SourceName{"ALORO38XMA", QT_TRANSLATE_NOOP("Source", "aloro.org, steel 38ХМА")},
    SourceName{"ALLMETALS38XMA", QT_TRANSLATE_NOOP("Source", "allmetals.ru, steel 38ХМА")},
    SourceName{"ALTERMET12XH3A", QT_TRANSLATE_NOOP("Source", "altermet.ru, steel 12ХН3А")},
    SourceName{"URALPROKAT40", QT_TRANSLATE_NOOP("Source", "uralprokatmetiz.ru, steel 40")},
    SourceName{"URALPROKAT45", QT_TRANSLATE_NOOP("Source", "uralprokatmetiz.ru, steel 45")},
    SourceName{"FERROTRADESHX15", QT_TRANSLATE_NOOP("Source", "ferrotrade.org, steel ШХ15")},
    SourceName{"METALLIFE18XGT", QT_TRANSLATE_NOOP("Source", "metall.life, steel 18ХГТ")},
    SourceName{"SCRAPTRAFFICSCH25",
               QT_TRANSLATE_NOOP("Source", "scraptraffic.com, grey iron СЧ25")},
    SourceName{"STEELLIB", QT_TRANSLATE_NOOP("Source", "steel-lib, representative values")},
    SourceName{"GOST1412", QT_TRANSLATE_NOOP("Source", "GOST 1412, appendix 2, grey iron")},
};

} // namespace

QString sourceText(std::string_view key) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [key](const SourceName& name) { return name.key == key; });
    return found == names.end() ? QString() : QCoreApplication::translate("Source", found->text);
}

std::vector<std::pair<QString, QString>> sourceTexts() {
    std::vector<std::pair<QString, QString>> texts;
    for (const SourceName& name : names) {
        texts.emplace_back(QString::fromLatin1(name.key.data(), qsizetype(name.key.size())),
                           QCoreApplication::translate("Source", name.text));
    }
    return texts;
}

} // namespace sparkout
