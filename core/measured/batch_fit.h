// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/identification.h"

namespace sparkout {

/// Fits parameters to the sizes of finished parts, single or as summaries: compares the means of
/// the zones or sections with those of the project's cycle over all phases of the stock, which is
/// not known for a part [MODEL-13]. A common factor is searched over two and a half decades, for
/// the criterion has several valleys, and refined in the best of them. The setting of the gauge
/// shifts all places alike and is solved for.
///
/// Variances of the means follow from the parts, covariances from the parts measured in both
/// places; for summaries these are unknown, and places count as independent. Where there are more
/// places than parameters, the fit is refused for lack of fit beyond the 95 % quantile of Fisher's
/// distribution.
[[nodiscard]] Identification fitBatch(const Project& project, const IdentificationRequest& request,
                                      const std::stop_token& stop);

} // namespace sparkout
