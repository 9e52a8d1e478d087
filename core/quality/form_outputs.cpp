// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/form_outputs.h"

#include "core/text.h"
#include "core/units.h"

namespace sparkout {

namespace {

std::optional<double> knownUm(const ZoneFormFigures& zone, double value_mm) {
    return zone.isKnown ? std::optional(value_mm * units::umPerMm) : std::nullopt;
}

constexpr Output<ZoneFormFigures> zoneFormRows[] = {
    {{.label = SPARKOUT_NOOP("Output", "Roundness, minimum zone"),
      .brief = SPARKOUT_NOOP("Output", "Roundness"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Minimum zone, of the least round section of the zone.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.worst->minimumZone.deviation()); }},
    {{.key = "cylindricity_um",
      .label = SPARKOUT_NOOP("Output", "Cylindricity, minimum zone"),
      .brief = SPARKOUT_NOOP("Output", "Cylindricity"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Minimum zone, over all sections of the zone.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->cylindricity_mm); }},
    {{.key = "total_runout_um",
      .label = SPARKOUT_NOOP("Output", "Total runout"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "About the centre axis, over all sections, with the "
                                      "machine's own.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->totalRunout_mm); }},
    {{.key = "taper_um",
      .label = SPARKOUT_NOOP("Output", "Taper"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius at the zone's last section less that at its "
                                      "first, of the straight line through them.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->profile.taper_mm); }},
    {{.key = "crown_um",
      .label = SPARKOUT_NOOP("Output", "Crown"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Mean radius in the zone's middle less that at its ends: "
                                      "above 0 a barrel, below it a saddle.")},
     [](const ZoneFormFigures& of) { return knownUm(of, of.form->profile.crown_mm); }},
};

} // namespace

std::span<const Output<ZoneFormFigures>> zoneFormOutputs() {
    return zoneFormRows;
}

} // namespace sparkout
