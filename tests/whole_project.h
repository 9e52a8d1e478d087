// SPDX-License-Identifier: GPL-3.0-or-later
// A project with all its parts: project.h alone only declares them.
#pragma once

#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/sweep.h"
#include "core/project/wheel.h"
