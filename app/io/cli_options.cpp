// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_options.h"

#include "app/io/cli_io.h"
#include "app/manual/command_line.h"
#include "core/field.h"
#include "core/project/batch.h"
#include "words/measured_json.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace sparkout::cli {

namespace {

template <class Number>
std::optional<Number> numberIn(std::string_view text, Number low, Number high) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && value >= low && value <= high ? std::optional(value) : std::nullopt;
}

std::optional<int> countUpTo(const std::string& text, int most) {
    return numberIn(text, 1, most);
}

/// "I/N" with 1 ≤ I ≤ N.
std::optional<std::pair<int, int>> shardOf(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) {
        return std::nullopt;
    }
    const auto shards = countUpTo(text.substr(slash + 1), std::numeric_limits<int>::max());
    const auto index = shards ? countUpTo(text.substr(0, slash), *shards) : std::nullopt;
    return index ? std::optional(std::pair(*index, *shards)) : std::nullopt;
}

std::optional<Scenarios> scenariosOf(const std::string& text) {
    const auto choices = choicesOf<Scenarios>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (text == choices[i].key) {
            return static_cast<Scenarios>(i);
        }
    }
    return std::nullopt;
}

std::optional<Operation> operationOf(const std::string& text) {
    const auto choices = choicesOf<Operation>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (text == choices[i].key) {
            return Operation::ofIndex(i);
        }
    }
    return std::nullopt;
}

std::optional<std::string> fileName(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(text);
}

/// Puts a value that was read; false: it could not be.
template <class T, class U>
bool put(T& option, const std::optional<U>& value) {
    if (value) {
        option = *value;
    }
    return value.has_value();
}

/// An option that takes a value.
struct ValueOption {
    const char* command;
    const char* name;
    const char* needs; ///< what its value must be
    bool (*read)(const std::string& text, Options& options);
};

const ValueOption valueOptions[] = {
    {"simulate", "--trace", "a file name",
     [](const std::string& text, Options& options) { return put(options.trace, fileName(text)); }},
    {"batch", "--parts", "a number from 1 to 1000000",
     [](const std::string& text, Options& options) {
         return put(options.parts, countUpTo(text, 1'000'000));
     }},
    {"batch", "--seed", "a number from 0 to 2147483647",
     [](const std::string& text, Options& options) {
         return put(options.seed, numberIn(text, 0, std::numeric_limits<int>::max()));
     }},
    {"batch", "--threads", "a number from 1 to 1024",
     [](const std::string& text, Options& options) {
         return put(options.threads, countUpTo(text, 1024));
     }},
    {"sweep", "--threads", "a number from 1 to 1024",
     [](const std::string& text, Options& options) {
         return put(options.threads, countUpTo(text, 1024));
     }},
    {"batch", "--sensitivity", "a number from 1 to 65536",
     [](const std::string& text, Options& options) {
         return put(options.sensitivity, countUpTo(text, 65'536));
     }},
    {"batch", "--shard", "I/N, I from 1 to N",
     [](const std::string& text, Options& options) { return put(options.shard, shardOf(text)); }},
    {"batch", "--until-width", "a width in µm above 0",
     [](const std::string& text, Options& options) {
         return put(options.untilWidth_um, numberIn(text, 1e-9, 1e9));
     }},
    {"batch", "--scenarios", "corners, latin_hypercube, sobol or random",
     [](const std::string& text, Options& options) {
         return put(options.scenarios, scenariosOf(text));
     }},
    {"dressing", "--scenarios", "corners, latin_hypercube, sobol or random",
     [](const std::string& text, Options& options) {
         return put(options.scenarios, scenariosOf(text));
     }},
    {"batch", "--measured", "a file name",
     [](const std::string& text, Options& options) {
         return put(options.measured, fileName(text));
     }},
    {"measured", "--data", "a file name",
     [](const std::string& text, Options& options) { return put(options.data, fileName(text)); }},
    {"measured", "--fit", "parameters, as alpha,beta,size_offset",
     [](const std::string& text, Options& options) { return put(options.fit, fileName(text)); }},
    {"measured", "--loss", "none, huber or tukey",
     [](const std::string& text, Options& options) {
         options.loss = text;
         return robustLossOf(text).has_value();
     }},
    {"measured", "-o", "a file name",
     [](const std::string& text, Options& options) { return put(options.output, fileName(text)); }},
    {"phases", "--from", "a stock per side in mm above 0",
     [](const std::string& text, Options& options) {
         return put(options.from_mm, numberIn(text, 1e-9, 1e3));
     }},
    {"phases", "--to", "a stock per side in mm above 0",
     [](const std::string& text, Options& options) {
         return put(options.to_mm, numberIn(text, 1e-9, 1e3));
     }},
    {"new", "--length", "a length in mm from 0.1 to 10000",
     [](const std::string& text, Options& options) {
         return put(options.length_mm, numberIn(text, 0.1, 1e4));
     }},
    {"new", "--stock", "a stock per side in mm from 0.01 to 5",
     [](const std::string& text, Options& options) {
         return put(options.stock_mm, numberIn(text, 0.01, 5.0));
     }},
    {"new", "--ra", "Ra in µm above 0, up to 100",
     [](const std::string& text, Options& options) {
         return put(options.ra_um, numberIn(text, 1e-9, 1e2));
     }},
    {"new", "--operation", "plunge or traverse",
     [](const std::string& text, Options& options) {
         return put(options.operation, operationOf(text));
     }},
    {"new", "--shoulder", "headstock, tailstock or both",
     [](const std::string& text, Options& options) {
         options.shoulder = text;
         return text == "headstock" || text == "tailstock" || text == "both";
     }},
    {"new", "--machine", "a name of the catalogue",
     [](const std::string& text, Options& options) {
         return put(options.machine, fileName(text));
     }},
    {"new", "--wheel", "a name of the catalogue",
     [](const std::string& text, Options& options) { return put(options.wheel, fileName(text)); }},
    {"new", "--material", "a name of the catalogue",
     [](const std::string& text, Options& options) {
         return put(options.material, fileName(text));
     }},
    {"new", "-o", "a file name",
     [](const std::string& text, Options& options) { return put(options.output, fileName(text)); }},
    {"measured", "--trial", "parameters, as alpha,beta",
     [](const std::string& text, Options& options) { return put(options.trial, fileName(text)); }},
    {"measured", "--profile", "a file name",
     [](const std::string& text, Options& options) {
         return put(options.profile, fileName(text));
     }},
    {"measured", "--stiffness", "a file name",
     [](const std::string& text, Options& options) {
         return put(options.stiffness, fileName(text));
     }},
    {"measured", "--indicator", "part or system",
     [](const std::string& text, Options& options) {
         options.indicator = text;
         return text == "part" || text == "system";
     }},
    {"batch", "--rows", "a file name",
     [](const std::string& text, Options& options) { return put(options.rows, fileName(text)); }},
};

const ValueOption surfaceOption{nullptr, "--surface", "a name, a number from 1 or all",
                                [](const std::string& text, Options& options) {
                                    options.surface = text;
                                    return !text.empty();
                                }};

bool takesSurface(const std::string& command) {
    return command == "simulate" || command == "batch" || command == "sweep"
           || command == "remedies" || command == "measured" || command == "phases";
}

const ValueOption* valueOption(const std::string& command, const std::string& name) {
    if (takesSurface(command) && name == surfaceOption.name) {
        return &surfaceOption;
    }
    for (const ValueOption& option : valueOptions) {
        if (command == option.command && name == option.name) {
            return &option;
        }
    }
    return nullptr;
}

/// The place of an option that is given or not; null: the command has none of that name.
bool* switchOf(const std::string& name, Options& options) {
    const bool simulates = options.command == "simulate", runs = options.command == "batch";
    const bool batch = runs || options.command == "batch-merge";
    const bool sweeps = options.command == "sweep", mends = options.command == "remedies";
    const bool measures = options.command == "measured", decides = options.command == "phases";
    const bool dresses = options.command == "dressing", starts = options.command == "new";
    const bool checks = simulates || batch || measures || decides || dresses;
    const bool prints = checks || mends || sweeps;
    return prints && name == "--json"                                        ? &options.json
           : checks && name == "--check"                                     ? &options.check
           : simulates && name == "--batch"                                  ? &options.batch
           : (batch || sweeps) && name == "--csv"                            ? &options.csv
           : (runs || sweeps || measures || dresses) && name == "--progress" ? &options.progress
           : measures && name == "--roundness"                               ? &options.roundness
           : measures && name == "--stiffness-sheet"                         ? &options.sheet
           : (runs || starts || options.command == "examples") && name == "--force" ? &options.force
           : starts && name == "--bore"                                             ? &options.bore
                                                                                    : nullptr;
}

/// Options that contradict each other.
int checkTogether(const Options& options) {
    const int outputs = static_cast<int>(options.json) + static_cast<int>(options.csv)
                        + static_cast<int>(options.shard.has_value());
    if (outputs > 1) {
        return usageError("only one of --json, --csv and --shard");
    }
    if (options.shard && (options.untilWidth_um || options.sensitivity || options.check)) {
        return usageError("a shard knows too little for --until-width, --sensitivity or --check");
    }
    const int kinds = static_cast<int>(options.roundness || !options.profile.empty())
                      + static_cast<int>(!options.trial.empty())
                      + static_cast<int>(options.sheet || !options.stiffness.empty())
                      + static_cast<int>(!options.fit.empty() || !options.data.empty());
    if (kinds > 1) {
        return usageError("only one of --roundness, --trial, --stiffness and --fit");
    }
    const bool startsNew = options.command == "new";
    if (options.fit.empty() && (!options.loss.empty() || (!options.output.empty() && !startsNew))) {
        return usageError("--loss and -o need --fit");
    }
    if (!startsNew && isSameFile(options.output, options.operand)) {
        return usageError("-o would replace the project that is read: " + options.output);
    }
    if (!options.indicator.empty() && options.stiffness.empty() && !options.sheet) {
        return usageError("--indicator needs --stiffness or --stiffness-sheet");
    }
    if (options.command == "batch" && options.force && options.rows.empty()) {
        return usageError("--force needs --rows");
    }
    return done;
}

/// Only what the manual has is an option.
bool isOption(const std::string& command, const std::string& name) {
    const auto* row = manual::commandNamed(manual::commandLineProgram(), command);
    return row && manual::optionNamed(row->options, name);
}

} // namespace

int parse(const std::vector<std::string>& arguments, Options& options) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (options.command.empty()) {
            options.command = argument;
        } else if (argument.size() > 1 && argument[0] == '-'
                   && !isOption(options.command, argument)) {
            return usageError("unknown option " + argument);
        } else if (const ValueOption* option = valueOption(options.command, argument)) {
            if (++i == arguments.size() || !option->read(arguments[i], options)) {
                return usageError(argument + " needs " + option->needs);
            }
        } else if (bool* given = switchOf(argument, options)) {
            *given = true;
        } else if (argument.size() > 1 && argument[0] == '-') {
            return usageError("unknown option " + argument);
        } else if (options.operand.empty()) {
            options.operand = argument;
        } else if (options.command == "batch-merge") {
            options.operands.push_back(argument);
        } else {
            return usageError("one file or folder too many: " + argument);
        }
    }
    return checkTogether(options);
}

} // namespace sparkout::cli
