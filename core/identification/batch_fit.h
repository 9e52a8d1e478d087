// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

namespace sparkout {

/// Parameters from the sizes of finished parts, one by one or summed up: the means of the zones or
/// sections against those of the project's cycle over all phases of the stock, which no part states
/// [MODEL-13]. A common factor is searched over two and a half decades, for the criterion has
/// several valleys, and refined in the best of them. The setting of the gauge moves all places
/// alike and is solved for.
///
/// Means vary as the parts do, and go together as the parts that were measured in both places; of
/// what is summed up that is not known, and each place counts by itself. Where there are more
/// places than parameters, the fit is refused as lacking beyond 95 % of Fisher's law of what is
/// left.
[[nodiscard]] Identification fitBatch(const Project& project, const IdentificationRequest& request,
                                      const std::stop_token& stop);

} // namespace sparkout
