// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/tour.h"

class QMainWindow;

namespace sparkout {

class InputsPanel;
class ViewTabs;

[[nodiscard]] std::vector<TourStep> tourSteps(QMainWindow& window, InputsPanel& inputs,
                                              ViewTabs& tabs);

} // namespace sparkout
