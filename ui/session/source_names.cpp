// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/source_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

struct SourceName {
    std::string_view key; ///< of core/SOURCES.md
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
    SourceName{"MARKING", QT_TRANSLATE_NOOP("Source", "the marking on the wheel itself")},
    SourceName{"HASHIMOTO2020", QT_TRANSLATE_NOOP("Source", "Hashimoto, 2020, contact stiffness "
                                                            "of the wheel")},
};

} // namespace

QString sourceText(std::string_view key) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [key](const SourceName& name) { return name.key == key; });
    return found == names.end() ? QString() : QCoreApplication::translate("Source", found->text);
}

} // namespace sparkout
