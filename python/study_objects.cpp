// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/study_objects.h"

#include "core/deadline_stop.h"
#include "core/file/file_system.h"
#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/work.h"
#include "core/measured/calibration.h"
#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "core/quality/waviness_outputs.h"
#include "core/search/optimise.h"
#include "core/sparkout.h"
#include "core/study/kept_search.h"
#include "core/study/wave_causes.h"
#include "python/arrays.h"
#include "python/interruptible.h"
#include "python/output_attributes.h"
#include "python/project_object.h"
#include "python/requirement_list.h"
#include "words/issue_words.h"
#include "words/judgement_words.h"
#include "words/lesson_words.h"
#include "words/measured_words.h"
#include "words/search_words.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace sparkout::python {

namespace py = pybind11;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// As many as the command line takes; 0: one a processor.
void expectThreads(int threads) {
    constexpr int most = 1024;
    if (threads < 0 || threads > most) {
        throw py::value_error("threads: " + std::to_string(threads) + "; allowed: 0…"
                              + std::to_string(most));
    }
}

// --- one cycle ----------------------------------------------------------------------------------

struct Evaluation {
    OutcomePtr outcome;
    BatchJudgement by{}; ///< empty where no batch was asked for

    [[nodiscard]] const SimulationResult& result() const { return outcome->result; }
};

Evaluation evaluateProject(const ValidProject& project, bool batch, int threads) {
    expectThreads(threads);
    Evaluation evaluation = interruptible([&](const std::stop_token& stop) {
        Evaluation made{evaluate(project.project, stop)};
        if (batch && made.outcome && made.result().status == RunStatus::completed) {
            BatchOptions options;
            options.threads = threads;
            options.stop = stop;
            made.by = judgeBatchOf(project.project, options);
        }
        return made;
    });
    if (!evaluation.by.issues.empty()) {
        raiseFaults(evaluation.by.issues);
    }
    return evaluation;
}

/// Decided when it is asked for: a run alone is much quicker.
Judgement judgementOf(const Evaluation& self) {
    return interruptible([&](const std::stop_token& stop) {
        return judge(self.result(), self.outcome->constraints, judgeStocks(self.result(), stop),
                     self.by.batch, self.by.measured);
    });
}

struct JudgedStocksOf {
    StocksDecision decision;
};

py::dict sectionDict(const ZoneFigures& zone, int number) {
    using namespace py::literals;
    const SectionResult& section = *zone.section;
    const double nominal_mm = zone.project->part->diameter_mm;
    py::dict dict("where"_a = sectionName(section.zone, number),
                  "radii_mm"_a = arrayOf(section.radii_mm),
                  "diameter_min_mm"_a = nominal_mm + section.diameterDeviationMin_mm,
                  "diameter_max_mm"_a = nominal_mm + section.diameterDeviationMax_mm,
                  "radial_runout_mm"_a = section.radialRunout_mm);
    addOutputs(dict, positionOutputs(), section);
    addOutputs(dict, zoneOutputs(), zone);
    if (zone.ifEven) {
        addOutputs(dict, evenLobesOutputs(), zone);
    }
    if (zone.form) {
        addOutputs(dict, zoneFormOutputs(), zone);
    }
    return dict;
}

py::list sectionsOf(const Evaluation& self) {
    py::list list;
    int number = 0;
    for (const ZoneFigures& zone : zonesOf(self.result(), self.outcome->accuracy)) {
        py::dict section = sectionDict(zone, number);
        if (const auto waves = placeWaves(self.result(), static_cast<std::size_t>(number))) {
            py::dict of;
            addOutputs(of, wavinessOutputs(), *waves);
            section["waviness"] = of;
        }
        list.append(std::move(section));
        ++number;
    }
    return list;
}

struct PartForm {
    OutcomePtr outcome;

    [[nodiscard]] PartFigures figures() const {
        return {outcome->accuracy, FinishedSurface(outcome->result.project)};
    }
};

py::list requirementsOf(const Evaluation& self) {
    return requirementList(self.outcome->constraints);
}

/// Of a zone or section, double stroke by double stroke or revolution by revolution.
py::dict feedsDict(const FeedPoints& points) {
    py::dict dict;
    const auto add = [&](const char* name, auto of) { dict[name] = arrayOfEach(points, of); };
    add("count", [](const FeedPoint& p) { return p.place.cycleCount; });
    add("stage", [](const FeedPoint& p) { return p.place.stage; });
    add("start_s", [](const FeedPoint& p) { return p.start_s; });
    add("end_s", [](const FeedPoint& p) { return p.end_s; });
    add("programmed_um", [](const FeedPoint& p) { return p.programmed_um.mean; });
    add("actual_um", [](const FeedPoint& p) { return p.actual_um.mean; });
    add("actual_min_um", [](const FeedPoint& p) { return p.actual_um.min; });
    add("actual_max_um", [](const FeedPoint& p) { return p.actual_um.max; });
    add("programmed_sum_um", [](const FeedPoint& p) { return p.programmedSum_um.mean; });
    add("actual_sum_um", [](const FeedPoint& p) { return p.actualSum_um.mean; });
    add("left_um", [](const FeedPoint& p) { return p.left_um.mean; });
    add("force_n", [](const FeedPoint& p) { return p.force_n.mean; });
    return dict;
}

/// What was too long to be recorded has neither feeds nor a trace.
void expectRecorded(const Evaluation& self) {
    if (self.result().visits > maxRecordedVisits) {
        throw py::value_error("the run has " + std::to_string(self.result().visits)
                              + " visits of a radius; recorded are at most "
                              + std::to_string(maxRecordedVisits));
    }
}

py::dict feedsOf(const Evaluation& self) {
    expectRecorded(self);
    py::dict dict;
    for (const FeedColumn& column : self.outcome->feeds.columns) {
        dict[py::str(sectionName(column.zone, column.section))] = feedsDict(column.strokes);
    }
    return dict;
}

/// Every visit of a radius, column by column.
py::dict traceOf(const Evaluation& self) {
    const Trajectory& trajectory = self.outcome->trajectory;
    expectRecorded(self);
    const auto radii = static_cast<std::size_t>(trajectory.radii);
    std::vector<double> section, stage, radius;
    for (std::size_t i = 0; i < trajectory.visits.size(); ++i) {
        const Place& at = trajectory.passes[i / radii].place;
        section.push_back(at.zone == Zone::section ? at.section : static_cast<int>(at.zone));
        stage.push_back(at.stage);
        radius.push_back(static_cast<double>(i % radii));
    }
    const auto& visits = trajectory.visits;
    py::dict dict;
    dict["section"] = arrayOf(section);
    dict["stage"] = arrayOf(stage);
    dict["radius"] = arrayOf(radius);
    dict["time_s"] = arrayOfEach(visits, [](const Visit& v) { return v.time_s; });
    dict["programmed_mm"] = arrayOfEach(visits, [](const Visit& v) { return v.programmed_mm; });
    dict["actual_mm"] = arrayOfEach(visits, [](const Visit& v) { return v.actual_mm; });
    dict["accumulated_mm"] = arrayOfEach(visits, [](const Visit& v) { return v.accumulated_mm; });
    dict["radius_mm"] = arrayOfEach(visits, [](const Visit& v) { return v.radius_mm; });
    dict["normal_force_n"] = arrayOfEach(visits, [](const Visit& v) { return v.normalForce_n; });
    return dict;
}

bool allHold(const Evaluation& self) {
    bool hold = self.result().status == RunStatus::completed;
    for (const ConstraintResult& each : self.outcome->constraints) {
        hold = hold && each.holds;
    }
    return hold;
}

void bindJudgement(py::module_& module) {
    py::class_<JudgedStocksOf> stocks(module, "JudgedStocks",
                                      "A cycle over every stock within one infeed.");
    bindOutputs(stocks, judgedStocksOutputs(), &JudgedStocksOf::decision);
    py::class_<Undecided> undecided(module, "Undecided",
                                    "A requirement that is asked for and not decided.");
    bindOutputs(undecided, undecidedOutputs());
    py::class_<JudgedBatch> batch(module, "JudgedBatch", "A cycle over the parts of a batch.");
    bindOutputs(batch, judgedBatchOutputs());
    py::class_<MeasuredBias> bias(module, "MeasuredBias",
                                  "Measured parts that differ from the predicted ones.");
    bindOutputs(bias, measuredBiasOutputs());
    py::class_<Judgement> judgement(module, "Judgement", "How a cycle stands.");
    bindOutputs(judgement, judgementOutputs());
    judgement
        .def_property_readonly("stocks",
                               [](const Judgement& self) { return JudgedStocksOf{self.stocks}; })
        .def_property_readonly("batch", [](const Judgement& self) { return self.batch; })
        .def_property_readonly("measured", [](const Judgement& self) { return self.measured; })
        .def_property_readonly("not_decided",
                               [](const Judgement& self) { return self.notDecided; });
}

void bindEvaluation(py::module_& module) {
    py::class_<PartForm> part(module, "PartForm", "The form of the whole part.");
    bindOutputs(part, partOutputs(), &PartForm::figures);
    py::class_<BurnState> burn(module, "Burn", "The pass nearest to burning.");
    bindOutputs(burn, burnOutputs());
    py::class_<Evaluation>(module, "Evaluation", "A cycle that was run, and what came out of it.")
        .def_property_readonly(
            "status", [](const Evaluation& self) { return statusKey(self.result().status); })
        .def_property_readonly("holds", &allHold,
                               "whether it reached size and every requirement holds")
        .def_property_readonly("time_s",
                               [](const Evaluation& self) { return self.result().time_s; })
        .def_property_readonly(
            "count", [](const Evaluation& self) { return self.result().cycleCount; },
            "double strokes or revolutions")
        .def_property_readonly(
            "time_by_stage_s",
            [](const Evaluation& self) { return arrayOf(self.result().timeByStage_s); })
        .def_property_readonly(
            "peak_normal_force_n",
            [](const Evaluation& self) { return self.result().peakNormalForce_n; })
        .def_property_readonly("peak_power_w",
                               [](const Evaluation& self) { return self.result().peakPower_w; })
        .def_property_readonly("sections", &sectionsOf)
        .def_property_readonly("part",
                               [](const Evaluation& self) { return PartForm{self.outcome}; })
        .def_property_readonly(
            "burn", [](const Evaluation& self) { return burnStateOf(self.result()); },
            "None where no temperature rise that burns is given")
        .def_property_readonly("requirements", &requirementsOf)
        .def_property_readonly("warnings",
                               [](const Evaluation& self) { return self.outcome->issues; })
        .def_property_readonly("judged", &judgementOf,
                               "for every stock within one infeed, decided on each call, and for "
                               "the batch that `evaluate` was asked for")
        .def("feeds", &feedsOf,
             "Arrays by zone or section, a value for each double stroke or revolution.")
        .def("trace", &traceOf, "Arrays with a value for every visit of a radius.")
        .def(
            "to_dict",
            [](const Evaluation& self) {
                return fromJson(
                    judgedResultJson(self.result(), self.outcome->constraints, judgementOf(self)));
            },
            "As `sparkout-cli simulate --json` has it, with a batch `simulate --batch --json`.");
    module.def("evaluate", &evaluateProject, py::arg("project"), py::kw_only(),
               py::arg("batch") = false, py::arg("threads") = 0,
               "Runs the cycle and holds it against the drawing; with `batch` also the project's "
               "batch, by which and by the project's measured parts it is judged.");
}

// --- many cycles --------------------------------------------------------------------------------

/// A batch with its parts one by one.
struct Batch {
    BatchResult result;
    std::vector<std::string> factors, quantities;
    std::vector<double> factorValues, values; ///< part by part
    std::vector<double> good;
};

Batch runBatchOf(const ValidProject& project, int threads) {
    expectThreads(threads);
    if (const Issues issues = checkBatch(project.project); hasErrors(issues)) {
        raiseFaults(issues);
    }
    return interruptible([&](const std::stop_token& stop) {
        Batch batch;
        const ScenarioSource source(project.project);
        for (const GivenFactor& factor : source.factors()) {
            batch.factors.emplace_back(factorKey(factor));
        }
        const std::vector<Characteristic> characteristics = characteristicsOf(source.nominal());
        for (const Characteristic& of : characteristics) {
            batch.quantities.push_back(std::string(of.name) + ' '
                                       + sectionOrPart(of.zone, of.section) + " [" + of.unit + ']');
        }
        BatchOptions options;
        options.threads = threads;
        options.stop = stop;
        options.sink = [&](const PartRecord& record) {
            batch.factorValues.insert(batch.factorValues.end(), record.factors.begin(),
                                      record.factors.end());
            for (std::size_t i = 0; i < characteristics.size(); ++i) {
                batch.values.push_back(record.outcome.completed ? record.outcome.values[i] : none);
            }
            batch.good.push_back(record.outcome.good ? 1 : 0);
            return true;
        };
        batch.result = runBatch(project.project, options);
        return batch;
    });
}

void bindBatch(py::module_& module) {
    py::class_<Batch>(module, "Batch", "The parts of a batch.")
        .def_property_readonly("status",
                               [](const Batch& self) { return batchStatusKey(self.result.status); })
        .def_readonly("factors", &Batch::factors, "names of the columns of factor_values")
        .def_readonly("quantities", &Batch::quantities, "names of the columns of values")
        .def_property_readonly(
            "factor_values",
            [](const Batch& self) { return matrixOf(self.factorValues, self.factors.size()); },
            "a row for every part")
        .def_property_readonly(
            "values",
            [](const Batch& self) { return matrixOf(self.values, self.quantities.size()); },
            "a row for every part; NaN where there is none")
        .def_property_readonly(
            "good", [](const Batch& self) { return arrayOf(self.good).attr("astype")("bool"); },
            "of every part, whether all its requirements hold")
        .def(
            "to_dict", [](const Batch& self) { return fromJson(batchJson(self.result)); },
            "Statistics, capability, verdict and worst part as `sparkout-cli batch --json` has "
            "them.");
    module.def("batch", &runBatchOf, py::arg("project"), py::arg("threads") = 0,
               "Runs the batch of the project, the same for any number of threads.");
}

SweepResult runSweepOf(const ValidProject& project, int threads) {
    expectThreads(threads);
    if (const Issues issues = checkSweep(project.project); hasErrors(issues)) {
        raiseFaults(issues);
    }
    return interruptible([&](const std::stop_token& stop) {
        SweepOptions options;
        options.threads = threads;
        options.stop = stop;
        return runSweep(project.project, options);
    });
}

/// A row a point, a column a quantity.
Array sweepMatrix(const SweepResult& sweep, double SweepValue::*which) {
    std::vector<double> values;
    for (const SweepPoint& point : sweep.points) {
        for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
            values.push_back(point.values.empty() ? none : point.values[q].*which);
        }
    }
    return matrixOf(values, sweep.quantities.size());
}

void bindSweep(py::module_& module) {
    py::class_<SweepResult> found(module, "Sweep", "The points of a sweep.");
    bindOutputs(found, sweepOutputs());
    found
        .def_property_readonly(
            "inputs",
            [](const SweepResult& self) {
                py::dict inputs;
                for (const SweptInput& input : self.inputs) {
                    inputs[py::str(input.axis.input)] = arrayOf(input.values);
                }
                return inputs;
            },
            "values of what is varied, by JSON pointer")
        .def_property_readonly(
            "points",
            [](const SweepResult& self) {
                std::vector<double> values;
                for (std::size_t i = 0; i < self.points.size(); ++i) {
                    const std::vector<double> at = self.valuesAt(i);
                    values.insert(values.end(), at.begin(), at.end());
                }
                return matrixOf(values, self.inputs.size());
            },
            "the inputs' values at each point")
        .def_property_readonly(
            "quantities",
            [](const SweepResult& self) {
                std::vector<std::string> names;
                for (const SweepQuantity& of : self.quantities) {
                    names.push_back(of.name + ' ' + sectionOrPart(of.zone, of.section)
                                    + (of.unit.empty() ? "" : " [" + of.unit + ']'));
                }
                return names;
            },
            "names of the columns of values and margins")
        .def_property_readonly(
            "values", [](const SweepResult& self) { return sweepMatrix(self, &SweepValue::value); })
        .def_property_readonly(
            "margins",
            [](const SweepResult& self) { return sweepMatrix(self, &SweepValue::margin); })
        .def_property_readonly("statuses",
                               [](const SweepResult& self) {
                                   std::vector<std::string> names;
                                   for (const SweepPoint& point : self.points) {
                                       names.emplace_back(sweepStatusKey(point.status));
                                   }
                                   return names;
                               })
        .def(
            "to_dict",
            [](const SweepResult& self) { return fromJson(sweepJson(self, issueSentence)); },
            "All that `sparkout-cli sweep --json` states.");
    module.def("sweep", &runSweepOf, py::arg("project"), py::arg("threads") = 0,
               "Runs the sweep of the project, the same for any number of threads.");
}

// --- search -------------------------------------------------------------------------------------

void warn(const std::string& text) {
    if (PyErr_WarnEx(PyExc_RuntimeWarning, text.c_str(), 1) != 0) {
        throw py::error_already_set();
    }
}

/// Raises OSError, or ValueError where the file is of something else.
void openKept(KeptSearch& kept, const std::filesystem::path& file) {
    if (const auto fault = kept.open()) {
        if (const auto* error = std::get_if<FileError>(&*fault)) {
            raiseFileError(*error);
        }
        throw py::value_error(
            "resume: " + utf8(file) + ": "
            + searchStateRefusal(std::get<ReadSearchState>(*fault), kept.question()));
    }
}

SearchOutcomePtr runSearchOf(const ValidProject& project, SearchWish wish,
                             const std::string& method, std::optional<double> timeLimit_s,
                             const std::optional<std::filesystem::path>& resume) {
    if (timeLimit_s && !(*timeLimit_s >= 0)) {
        throw py::value_error("time_limit_s: " + std::to_string(*timeLimit_s)
                              + " s; allowed: ≥ 0 s");
    }
    const auto named = searchMethodNamed(method);
    if (!named) {
        throw py::value_error("method: " + method + "; allowed: search, full, dp or labels");
    }
    wish.method = *named;
    if (resume && !isResumable(project.project, wish.method)) {
        throw py::value_error("resume needs the method full and the objective time");
    }
    std::optional<KeptSearch> kept;
    std::optional<FileError> lost;
    if (resume) {
        kept.emplace(*resume, searchQuestion(project.project, wish));
        kept->onFailure = [&lost](const FileError& error) { lost = error; };
        openKept(*kept, *resume);
        wish.journal = &kept->journal();
    }
    SearchOutcomePtr outcome = interruptible([&](const std::stop_token& stop) {
        const DeadlineStop limit(
            stop, timeLimit_s ? std::optional<DeadlineStop::Duration>(*timeLimit_s) : std::nullopt);
        SearchOutcomePtr found = search(project.project, wish, limit.token());
        if (kept) { // also where it is interrupted
            kept->close();
        }
        return found;
    });
    if (lost) { // its answer stands
        warn("the progress is not kept: " + lost->path + ": " + fileStepText(lost->step));
    }
    if (kept && kept->journal().hasRefused()) {
        warn("resume: a cycle in the file is not of this search, or does not take the time that "
             "stands there; that search was made anew");
    }
    if (!outcome->ran()) {
        Issues issues = outcome->issues;
        issues.insert(issues.end(), outcome->batchIssues.begin(), outcome->batchIssues.end());
        if (!issues.empty()) {
            raiseFaults(issues);
        }
        raiseRefusal(searchRefusal(*outcome));
    }
    return outcome;
}

std::optional<double> searchTime_s(const SearchOutcome& self) {
    return self.answer() ? std::optional(self.answer()->time_s) : std::nullopt;
}

std::optional<ValidProject> projectFound(const SearchOutcome& self) {
    return self.answer() ? std::optional(checkedProject(withFound(self.project, *self.answer())))
                         : std::nullopt;
}

std::optional<double> limitOf_s(const SearchOutcome& self) {
    return isKnownLimit(self.limit.time_s) ? std::optional(self.limit.time_s) : std::nullopt;
}

std::optional<std::vector<std::string>> bindingOf(const SearchOutcome& self) {
    if (!self.binding) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const ConstraintKind kind : *self.binding) {
        names.emplace_back(requirementOf(kind).key);
    }
    return names;
}

void bindSearch(py::module_& module) {
    py::class_<SearchOutcome, std::shared_ptr<SearchOutcome>> found(module, "Search",
                                                                    "What a search found.");
    bindOutputs(found, searchOutputs());
    found.def_property_readonly("time_s", &searchTime_s, "of the cycle found; None without one")
        .def_property_readonly("project", &projectFound, "with the cycle found; None without one")
        .def_property_readonly(
            "bound_s", [](const SearchOutcome& self) { return self.search.bound_s; },
            "no cycle of the grid that holds is quicker; for the maximum margin the limit")
        .def_property_readonly(
            "limit_s", &limitOf_s,
            "of the stepless cycle: no cycle of those that limit_cycles names is quicker; None "
            "where none is known")
        .def_property_readonly(
            "limit_cycles",
            [](const SearchOutcome& self) {
                const LimitedCycles& cycles = self.limit.cycles;
                py::dict names;
                names["continuous_feed_mm_min"] = cycles.continuousFeed_mm_min;
                names["draw_back"] = cycles.drawBack;
                names["spark_out_by_count"] = cycles.sparkOut;
                return names;
            },
            "which cycles limit_s is of, as in the JSON of optimize")
        .def_property_readonly(
            "binding", &bindingOf,
            "requirements that fail in quicker cycles nearby, or for the maximum margin those "
            "that have the least; None where not known")
        .def_property_readonly(
            "text",
            [](const SearchOutcome& self) {
                return SearchWording().answer(self, self.given.time_s);
            },
            "what came out, a sentence each, as the command line and the window say it")
        .def(
            "to_dict", [](const SearchOutcome& self) { return fromJson(searchJson(self)); },
            "All that `sparkout-cli optimize --json` states.");
    module.def(
        "search",
        [](const ValidProject& project, bool robust, bool refine, bool front,
           const std::string& method, std::optional<double> timeLimit_s,
           const std::optional<std::filesystem::path>& resume) {
            return std::const_pointer_cast<SearchOutcome>(
                runSearchOf(project, {.phases = robust, .refine = refine, .front = front}, method,
                            timeLimit_s, resume));
        },
        py::arg("project"), py::kw_only(), py::arg("robust") = false, py::arg("refine") = false,
        py::arg("front") = false, py::arg("method") = "search",
        py::arg("time_limit_s") = py::none(), py::arg("resume") = py::none(),
        "Finds the quickest cycle of the project's grid that meets every requirement, or where "
        "margin_within_min is given the one of the maximum margin within that time. `front`: the "
        "best cycle of each number of stages and margins by time, too, in to_dict(). `method`: "
        "search, full, dp or labels. `resume`: a file in which the search of the method full keeps "
        "its progress, every second and at a stop, and from which it is continued, as with "
        "--resume of the command line. A project has no wear of the wheel: an objective of cost or "
        "wheel life has the quickest cycle as its answer.");
}

// --- measured and course ------------------------------------------------------------------------

/// A project with what was measured of it, and what that says.
struct MeasuredProject {
    Project project;
    MeasuredAnswer answer;
};

MeasuredProject measure(const ValidProject& given, const std::optional<std::string>& table,
                        const std::optional<std::string>& fit, const std::string& lossKey,
                        int threads) {
    expectThreads(threads);
    MeasuredProject found{given.project, {}};
    Project& project = found.project;
    const auto loss = robustLossOf(lossKey);
    if (!loss) {
        throw py::value_error("loss: " + lossKey + "; allowed: none, huber, tukey");
    }
    if (table) {
        ReadMeasured read =
            readMeasured(*table, proposeTable(*table), {"table", project.part->diameter_mm, 0});
        if (!read.faults.empty()) {
            const CellFault& first = read.faults.front();
            throw py::value_error("table: line " + std::to_string(first.line) + ", column "
                                  + std::to_string(first.column) + ": "
                                  + Wording().sentence(first.issue));
        }
        Measured& measured = project.measured ? *project.measured : project.measured.emplace();
        std::ranges::move(read.data.parts, std::back_inserter(measured.parts));
        std::ranges::move(read.data.traces, std::back_inserter(measured.traces));
    }
    MeasuredAnswer& answer = found.answer;
    if (fit) {
        const auto parameters = fittedParametersOf(*fit);
        if (!parameters) {
            throw py::value_error("fit: " + *fit + "; allowed: " + knownParameters() + "; "
                                  + parameterHint());
        }
        answer.parameters = *parameters;
    }
    if (!project.measured
        || (project.measured->parts.empty() && project.measured->traces.empty()
            && project.measured->summaries.empty())) {
        raiseRefusal("/measured: nothing is measured");
    }
    const Project predicting = predictingProject(project);
    const bool isJudged = !statisticsOfMeasured(project).empty();
    if (const Issues issues = isJudged ? checkBatch(predicting) : Issues(); !issues.empty()) {
        raiseFaults(issues);
    }
    interruptible([&](const std::stop_token& stop) {
        if (isJudged) {
            BatchOptions options;
            options.threads = threads;
            options.stop = stop;
            answer.rows = judgeAdequacy(project, runBatch(predicting, options));
        }
        answer.holdOut = holdOut(project, stop);
        if (fit) {
            answer.fit =
                identify(project, {answer.parameters, {}, !answer.rows.empty(), *loss}, stop);
        }
        return true;
    });
    if (answer.fit && answer.fit->status == IdentificationStatus::notRun
        && !answer.fit->issues.empty()) {
        raiseFaults(answer.fit->issues);
    }
    return found;
}

py::object measuredOf(const ValidProject& given, const std::optional<std::string>& table,
                      const std::optional<std::string>& fit, const std::string& loss, int threads) {
    const MeasuredProject found = measure(given, table, fit, loss, threads);
    return fromJson(measuredJson(found.project, found.answer));
}

ValidProject calibratedOf(const ValidProject& given, const std::string& fit,
                          const std::optional<std::string>& table, const std::string& loss,
                          const std::string& data, int threads) {
    const MeasuredProject found = measure(given, table, fit, loss, threads);
    const Identification& values = *found.answer.fit;
    if (values.status != IdentificationStatus::fitted) {
        raiseRefusal("fit: " + std::string(wordsOf(values.status).text));
    }
    return checkedProject(withCalibration(found.project, values, data, today()));
}

py::object checkLessonText(const std::string& text) {
    const ReadLesson read = readLesson(text);
    if (!read.lesson) {
        raiseFaults(read.issues);
    }
    return fromJson(interruptible([&](const std::stop_token& stop) {
        return lessonCheckJson(checkedAsGiven(*read.lesson, stop));
    }));
}

py::object checkWorkText(const std::string& text) {
    const ReadWork read = readWork(text);
    if (!read.work) {
        raiseFaults(read.issues);
    }
    return fromJson(interruptible([&](const std::stop_token&) {
        return workCheckJson(*read.work, checkedAnswers(*read.work));
    }));
}

void bindMeasured(py::module_& module) {
    module.def(
        "measured", &measuredOf, py::arg("project"), py::kw_only(), py::arg("table") = py::none(),
        py::arg("fit") = py::none(), py::arg("loss") = "none", py::arg("threads") = 0,
        "What was measured against the batch that the project predicts, and, of the "
        "parameters of `fit` (\"compliance,alpha\"; \"beta=1.2~0.1\" with the mean and the "
        "standard deviation of what is known before), their values: all that `sparkout-cli "
        "measured --json` states. `table`: the text of a table of parts or traces, beside "
        "what the project has. `loss`: none, or huber or tukey, by which outliers weigh less.");
    module.def("calibrated", &calibratedOf, py::arg("project"), py::kw_only(), py::arg("fit"),
               py::arg("table") = py::none(), py::arg("loss") = "none", py::arg("data") = "table",
               py::arg("threads") = 0,
               "The project with the inputs that such a fit finds, each recorded as calibrated on "
               "`data`. Refused where the fit has no values to use.");
    module.def("check_lesson", &checkLessonText, py::arg("text"),
               "What each step of a lesson finds as it is given, as `sparkout-cli course check "
               "--json` states it.");
    module.def("check_work", &checkWorkText, py::arg("text"),
               "The same of the answers of a student's work.");
}

// --- phases and dressing ------------------------------------------------------------------------

py::object phasesOf(const ValidProject& project, std::optional<double> from_mm,
                    std::optional<double> to_mm) {
    if (!canDecidePhases(project.project)) {
        raiseRefusal("/gauge/control: the phases of the stock are decided under gauge control "
                     "alone");
    }
    StockRange range = usualPhases(project.project);
    range = {from_mm.value_or(range.from_mm), to_mm.value_or(range.to_mm)};
    if (!(range.from_mm > 0 && range.from_mm <= range.to_mm)) {
        throw py::value_error("from_mm: " + std::to_string(range.from_mm)
                              + " mm; allowed: above 0, up to to_mm");
    }
    return fromJson(phasesJson(interruptible(
        [&](const std::stop_token& stop) { return decidePhases(project.project, range, stop); })));
}

py::object dressingOf(const std::string& text) {
    const ReadSetup read = readSetup(text);
    if (!read.setup) {
        raiseFaults(read.issues);
    }
    const DressingInterval interval = interruptible([&](const std::stop_token& stop) {
        DressingOptions options;
        options.stop = stop;
        return dressingInterval(*read.setup, options);
    });
    if (!interval.issues.empty()) {
        raiseFaults(interval.issues);
    }
    switch (interval.fault) {
    case DressingFault::none: break;
    case DressingFault::noWear:
        raiseRefusal(
            "/wear: not given; a dulling or a grinding ratio determines the wear of the wheel");
    case DressingFault::firstFails:
        raiseRefusal("the first part after dressing does not reach size");
    }
    return fromJson(dressingJson(*read.setup, interval));
}

py::object waveCausesOf(const ValidProject& project, int counted,
                        const std::vector<double>& frequencies_hz) {
    if (counted < fewestWaves || counted > mostWaves) {
        throw py::value_error("counted: " + std::to_string(counted) + "; allowed: "
                              + std::to_string(fewestWaves) + "…" + std::to_string(mostWaves));
    }
    for (const double each : frequencies_hz) {
        if (!(each >= lowestFrequency_hz && each <= highestFrequency_hz)) {
            throw py::value_error("frequencies_hz: " + std::to_string(each)
                                  + "; allowed: 0.1…100000 Hz");
        }
    }
    return fromJson(wavesJson(project.project, {counted, frequencies_hz}));
}

void bindDecisions(py::module_& module) {
    module.def("waves", &waveCausesOf, py::arg("project"), py::arg("counted"), py::kw_only(),
               py::arg("frequencies_hz") = std::vector<double>(),
               "What can have left the waves that were counted around a part, as "
               "`sparkout-cli waves --json` has it.");
    module.def("phases", &phasesOf, py::arg("project"), py::kw_only(),
               py::arg("from_mm") = py::none(), py::arg("to_mm") = py::none(),
               "Decides for which stocks per side of the blank the cycle meets every requirement, "
               "as `sparkout-cli phases --json` has it.");
    module.def("dressing", &dressingOf, py::arg("text"),
               "How many parts hold between two dressings, of the text of a file with one surface "
               "or several, as `sparkout-cli dressing --json` has it.");
}

} // namespace

void bindStudies(py::module_& module) {
    bindJudgement(module);
    bindEvaluation(module);
    bindBatch(module);
    bindSweep(module);
    bindSearch(module);
    bindMeasured(module);
    bindDecisions(module);
}

} // namespace sparkout::python
