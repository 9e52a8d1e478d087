// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public face of the core: a project read and checked, its cycle simulated, held against the
// drawing and evaluated, for which stocks it holds, what would help, its batch, its sweep, its
// search; what was measured, read, judged and fitted; and the surfaces of a part that are ground in
// one set-up.

#include "core/adequacy/adequacy.h"
#include "core/batch/batch_check.h"
#include "core/batch/batch_run.h"
#include "core/batch/batch_summary.h"
#include "core/format/project_file.h"
#include "core/identification/calibration.h"
#include "core/identification/identification.h"
#include "core/identification/wheel_calibration.h"
#include "core/measured/measured_table.h"
#include "core/phases/phase_decision.h"
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
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/constraints.h"
#include "core/quality/result_json.h"
#include "core/quality/shop_numbers.h"
#include "core/remedies/remedies.h"
#include "core/setup/setup_file.h"
#include "core/setup/setup_json.h"
#include "core/setup/setup_run.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"
#include "core/study/evaluate.h"
#include "core/study/grid_search.h"
#include "core/study/whole_batch.h"
#include "core/study/whole_search.h"
#include "core/sweep/sweep_run.h"
