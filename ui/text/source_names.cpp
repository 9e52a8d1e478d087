// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/source_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace sparkout {

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
