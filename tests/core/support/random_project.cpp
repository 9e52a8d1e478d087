// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/random_project.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

// The number with so many decimals that is nearest: files stay short.
double rounded(double x, int decimals) {
    double scale = 1;
    for (int i = 0; i < decimals; ++i) {
        scale *= 10;
    }
    return std::round(x * scale) / scale;
}

// splitmix64 (Steele, Lea, Flood 2014) with mappings of its own: no standard distribution, whose
// numbers differ between libraries.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    double uniform(double low, double high, int decimals) {
        return rounded(uniform(low, high), decimals);
    }
    int integer(int low, int high) {
        return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    template <typename T>
    T oneOf(std::initializer_list<T> values) {
        return values.begin()[integer(0, static_cast<int>(values.size()) - 1)];
    }

private:
    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }

    std::uint64_t m_state;
};

enum class LastStage { Feed, Count, UntilSize };

// What shall come out: kinds and sizes, chosen first because they bound the length of the cycle.
struct Plan {
    bool traverse = false;
    bool internal = false;
    bool positionControl = false;
    bool noFriction = false; // η = 0
    bool soft = false;       // spark-out until size from a large deflection, which is reached
    LastStage last = LastStage::Feed;
    int feedStages = 1;
    int K = 36;
    int J = 4;
    int passes = 0;             // about so many double strokes or revolutions of feed
    std::vector<double> stocks; // of the feed stages, as they are removed [mm]
    std::vector<double> feeds;  // of the feed stages [mm per double stroke or revolution]
    double runout = 0;          // ΔR [mm]
    double widest = 0;          // largest width of cut seen by the gauge [mm]
    double lastWidth = 0;       // and that of the last feed stage [mm]
};

Plan choosePlan(Random& random) {
    Plan plan;
    plan.traverse = random.chance(0.5);
    plan.internal = !plan.traverse && random.chance(0.35);
    plan.positionControl = random.chance(0.25);
    plan.noFriction = random.chance(0.15);
    const int stages = random.integer(1, 5);
    plan.feedStages = stages;
    if (stages > 1 && random.chance(0.55)) {
        plan.last = random.chance(0.5) ? LastStage::Count : LastStage::UntilSize;
        plan.feedStages = stages - 1;
    }
    plan.K = random.oneOf({4, 6, 8, 10, 12, 12, 18, 24, 36, 36, 36, 60, 90});
    plan.J = plan.traverse ? 1 : random.integer(1, 12);
    const bool untilSize = plan.last == LastStage::UntilSize;
    if (untilSize) { // it may go on for long
        plan.K = random.oneOf({4, 6, 8, 12});
        plan.J = std::min(plan.J, 4);
        plan.soft = !plan.positionControl && random.chance(0.6);
        plan.noFriction = random.chance(plan.positionControl ? 0.5 : 0.15);
    }
    const int budget = random.integer(1'500, 10'000); // visits of a radius
    plan.passes = plan.traverse ? std::clamp(budget / (12 * plan.K), 6, 100)
                                : std::clamp(budget / (plan.J * plan.K), 20, untilSize ? 250 : 600);
    return plan;
}

// Stocks and feeds of the feed stages, such that the cycle takes about plan.passes.
void chooseFeeds(Random& random, Plan& plan) {
    const double whole = random.uniform(0.03, 0.25);
    plan.runout = random.chance(0.1) ? 0 : random.uniform(0.002, 0.07, 3);
    std::vector<double> weights;
    double sum = 0;
    for (int z = 0; z < plan.feedStages; ++z) {
        weights.push_back(random.uniform(0.3, 1) / (z + 1));
        sum += weights.back();
    }
    for (int z = 0; z < plan.feedStages; ++z) {
        const double stock = std::max(0.001, rounded(whole * weights[z] / sum, 4));
        const double passes =
            std::max(1.0, plan.passes * random.uniform(0.4, 1) * (z == 0 ? 0.6 : 0.4 / z));
        plan.stocks.push_back(stock);
        plan.feeds.push_back(std::max(0.0001, (stock + (z == 0 ? plan.runout : 0)) / passes));
    }
}

json partOf(Random& random, const Plan& plan) {
    const double d = random.uniform(plan.internal ? 25 : 12, 130, 2);
    const int lower = random.integer(-40, 15);
    const int upper = lower + random.integer(3, 30);
    double stock = 0;
    for (const double stageStock : plan.stocks) {
        stock += stageStock;
    }
    json part = {{"diameter_mm", d},
                 {"upper_deviation_um", upper},
                 {"lower_deviation_um", lower},
                 {"stock_mm", rounded(stock, 4)},
                 {"initial_runout_mm", plan.runout}};
    if (plan.internal || random.chance(0.3)) {
        part["surface"] = plan.internal ? "internal" : "external";
    }
    if (plan.K != 36 || random.chance(0.5)) {
        part["radii_per_section"] = plan.K;
    }
    if (random.chance(0.2)) {
        part["target_diameter_mm"] = rounded(d + random.uniform(lower, upper) / 1000, 4);
    }
    return part;
}

// Deviations of a measured profile: a wave with noise, given from its highest point or not [µm].
std::vector<double> measuredProfile(Random& random, const Plan& plan) {
    const int waves = random.integer(1, 4);
    const double phase = random.uniform(0, 6);
    const double offset = random.chance(0.3) ? random.uniform(-20, 20) : 0;
    std::vector<double> um;
    for (int k = 0; k < plan.K; ++k) {
        const double wave = std::cos(2 * std::numbers::pi * waves * k / plan.K + phase);
        um.push_back(1000 * plan.runout * (0.4 * wave + random.uniform(-0.1, 0.1)));
    }
    const double largest = *std::max_element(um.begin(), um.end());
    for (double& deviation : um) {
        deviation = rounded(deviation - largest + offset, 2);
    }
    return um;
}

void addProfile(Random& random, const Plan& plan, json& part) {
    switch (random.integer(0, 5)) {
    case 0: part["profile"] = "ellipse"; break;
    case 1: part["profile"] = "eccentric"; break;
    case 2:
        part["profile"] = "lobes";
        if (random.chance(0.7)) {
            part["lobes"] = random.integer(2, 9);
        }
        break;
    case 3:
        part["profile"] = "measured";
        part["radii_um"] = measuredProfile(random, plan);
        if (random.chance(0.5)) { // the measured runout replaces this one
            part["initial_runout_mm"] = random.uniform(0, 0.05, 3);
        }
        break;
    default: // the file's default: ellipse
        break;
    }
}

json materialOf(Random& random) {
    json material = {{"flow_stress_mpa", random.integer(600, 2800)}};
    if (random.chance(0.5)) {
        material["shear_factor"] = random.uniform(1.5, 2.2, 2);
    }
    if (random.chance(0.3)) {
        material["shear_strain"] = random.uniform(2, 3.5, 2);
    }
    if (random.chance(0.3)) {
        material["friction"] = random.uniform(0.1, 0.6, 2);
    }
    return material;
}

json wheelOf(Random& random, const Plan& plan, double d) {
    const double width = random.uniform(plan.internal ? 10 : 15, plan.internal ? 50 : 70, 1);
    const double D =
        plan.internal ? random.uniform(0.35 * d, 0.9 * d, 1) : random.integer(250, 750);
    const double eta = plan.noFriction ? 0 : random.uniform(0.005, 0.15, 4);
    return {{"diameter_mm", D}, {"width_mm", width}, {"dullness", eta}};
}

double dwell(Random& random) {
    switch (random.integer(0, 3)) {
    case 0: return 0;
    case 1: return random.uniform(0.01, 0.1, 2); // often less than half a revolution
    default: return random.uniform(0.1, 1, 2);
    }
}

json machineOf(Random& random, const Plan& plan) {
    json machine = {{"wheel_speed_m_s", random.uniform(plan.internal ? 15 : 22, 50, 1)},
                    {"work_speed_rpm", random.integer(60, 350)}};
    if (random.chance(0.3)) {
        machine["geometric_runout_um"] = random.uniform(0.1, 3, 1);
    }
    if (plan.traverse) {
        const double largest = *std::max_element(plan.feeds.begin(), plan.feeds.end());
        const double n = machine["work_speed_rpm"];
        machine["plunge_feed_mm_min"] =
            rounded(std::max(0.01, n * largest / random.uniform(0.3, 8)), 3);
        machine["dwell_entry_s"] = dwell(random);
        machine["dwell_exit_s"] = dwell(random);
    }
    return machine;
}

// The wheel covers the ground length in plunge; in traverse a non-reversal zone is left.
void chooseLengths(Random& random, const Plan& plan, double B, json& part, json& machine) {
    if (!plan.traverse) {
        part["length_mm"] = random.chance(0.1) ? B : random.uniform(0.3 * B, B, 1);
        return;
    }
    double o1 = random.chance(0.1) ? 0 : random.uniform(0, 0.7 * B, 1);
    double o2 = random.chance(0.1) ? 0 : random.uniform(0, 0.7 * B, 1);
    if (plan.internal && random.chance(0.4)) { // the wall is at the headstock
        part["blind_bore"] = true;
        const bool entry = random.chance(0.5);
        machine["entry_side"] = entry ? "headstock" : "tailstock";
        (entry ? o1 : o2) = random.chance(0.5) ? 0 : -random.uniform(0.1, 0.3 * B, 1);
    }
    machine["overrun_entry_mm"] = o1;
    machine["overrun_exit_mm"] = o2;
    part["length_mm"] = rounded((B - o1) + (B - o2) + random.uniform(2, 150), 1);
}

json stagesOf(Random& random, Plan& plan, double n, double B, double L_p) {
    json stages = json::array();
    plan.widest = plan.lastWidth = plan.traverse ? 0 : L_p;
    const int count = plan.feedStages + (plan.last == LastStage::Feed ? 0 : 1);
    for (int z = 0; z < count; ++z) {
        json stage = json::object();
        if (plan.traverse) {
            const double share =
                random.chance(0.04) ? random.uniform(1, 1.2) : random.uniform(0.05, 0.6);
            const double axial = std::max(10.0, rounded(share * B * n, 0));
            stage["axial_feed_mm_min"] = axial;
            const double width = std::min(axial / n, B);
            plan.widest = std::max(plan.widest, width);
            plan.lastWidth = z < plan.feedStages ? width : plan.lastWidth;
        }
        if (z < plan.feedStages) {
            stage["stock_mm"] = plan.stocks[z];
            if (plan.traverse) {
                plan.feeds[z] = std::max(1e-5, rounded(plan.feeds[z], 5));
                stage["radial_feed_mm"] = plan.feeds[z];
            } else {
                stage["radial_feed_mm_min"] = std::max(0.01, rounded(plan.feeds[z] * n, 4));
                plan.feeds[z] = stage["radial_feed_mm_min"].get<double>() / n;
            }
        }
        stages.push_back(stage);
    }
    return stages;
}

// Stocks that do not sum up to the part's; with later stages' stocks larger than the whole, several
// stages end at one reading.
void disturbStocks(Random& random, const Plan& plan, json& part, json& stages, double n) {
    if (random.chance(0.6)) {
        return;
    }
    const double whole = part["stock_mm"];
    switch (random.integer(0, 2)) {
    case 0: stages[0]["stock_mm"] = random.uniform(0.001, 0.3, 4); break;
    case 1: part["stock_mm"] = rounded(whole * random.uniform(0.6, 1.4), 4); break;
    default:
        if (plan.feedStages > 1) {
            const int z = random.integer(1, plan.feedStages - 1);
            stages[z]["stock_mm"] = rounded(whole * random.uniform(0.9, 1.6), 4);
            const char* key = plan.traverse ? "radial_feed_mm" : "radial_feed_mm_min";
            const double feed = (whole + plan.runout) / plan.passes * (plan.traverse ? 1 : n);
            stages[z][key] = rounded(std::max(stages[z][key].get<double>(), feed), 5);
        }
        break;
    }
}

// The two terms of γ·P_y for the gauge's place: deflection = linear·a + root·√a.
struct Deflection {
    double linear = 0; // γ·b·k_s [–]
    double root = 0;   // γ·b·k_r [√mm]

    double at(double a) const { return linear * a + root * std::sqrt(a); }
};

Deflection deflectionOf(const Plan& plan, const json& project, double gamma, double width) {
    const json& wheel = project["wheel"];
    const json& machine = project["machine"];
    const double d = project["part"]["diameter_mm"];
    const double D = wheel["diameter_mm"];
    const double sigma = project["material"]["flow_stress_mpa"];
    const double eta = wheel["dullness"];
    const double n = machine["work_speed_rpm"];
    const double V_k = machine["wheel_speed_m_s"];
    const double D_e = plan.internal ? d * D / (d - D) : d * D / (d + D);
    const double k_s = 2 * sigma * std::numbers::pi * d * n / (V_k * 60'000);
    const double k_r = eta * sigma * std::sqrt(D_e) / 3;
    return {gamma * width * k_s, gamma * width * k_r};
}

// γ, at most so large that the deflection does not govern the length of the cycle.
double chooseCompliance(Random& random, const Plan& plan, const json& project) {
    const double fastest = *std::max_element(plan.feeds.begin(), plan.feeds.end());
    const double gamma = random.uniform(1e-5, 2e-4);
    const Deflection deflection = deflectionOf(plan, project, gamma, plan.widest);
    const double largest = 0.8 * (plan.stocks[0] + plan.runout);
    double scale = std::min(1.0, largest / deflection.at(fastest));
    if (plan.last == LastStage::UntilSize) {
        // Without friction removal falls as ((A − 1)/A)^m; with it, root²/m² is to come down to
        // 1e-9 mm.
        const double root = plan.soft ? 0.2 : plan.traverse ? 0.008 : 0.02;
        scale = std::min(scale, 3 / deflection.linear);
        if (deflection.root > 0) {
            scale = std::min(scale, root / deflection.root);
        }
    }
    return gamma * scale;
}

json spread(Random& random, const Plan& plan, double gamma) {
    const auto one = [&] { return std::max(1e-9, rounded(gamma * random.uniform(0.6, 1.3), 10)); };
    if (plan.traverse) {
        return {{"rz1", one()}, {"nz", one()}, {"rz2", one()}};
    }
    json list = json::array();
    for (int j = 0; j < plan.J; ++j) {
        list.push_back(one());
    }
    return list;
}

void completeSparkOut(Random& random, const Plan& plan, const json& project, double gamma,
                      json& stage) {
    // What the gauge's place still has to give when the feed ends; after two strokes it is less.
    const double a = plan.feeds.back() / (plan.traverse ? 6 : 1);
    const double deflection = deflectionOf(plan, project, gamma, plan.lastWidth).at(a);
    if (plan.last == LastStage::Count) {
        stage["spark_out"] = random.integer(1, plan.traverse ? 10 : 40);
    } else {
        stage["spark_out"] = "until_size";
    }
    const double share = plan.soft ? random.uniform(0.02, 0.2) : random.uniform(0.05, 2.5);
    if (plan.soft || random.chance(0.7)) {
        const double most = 0.3 * project["part"]["stock_mm"].get<double>();
        stage["stock_mm"] = std::max(1e-6, rounded(std::min(most, share * deflection), 6));
    } else if (random.chance(0.3)) {
        stage["stock_mm"] = 0;
    }
    if (random.chance(0.3)) { // it is ignored
        stage[plan.traverse ? "radial_feed_mm" : "radial_feed_mm_min"] = 0.001;
    }
}

json gaugeOf(Random& random, const Plan& plan, double L_p, double gamma) {
    json gauge = json::object();
    if (plan.positionControl || random.chance(0.3)) {
        gauge["control"] = plan.positionControl ? "position" : "gauge";
    }
    const char* rule = random.oneOf({"", "min", "mean", "max"});
    if (*rule != '\0') {
        gauge["rule"] = rule;
    }
    if (plan.traverse) {
        return gauge;
    }
    if (random.chance(0.35)) {
        gauge["position_mm"] = random.uniform(0, L_p, 1);
        if (random.chance(0.5)) {
            gauge["compliance_mm_per_n"] =
                std::max(1e-9, rounded(gamma * random.uniform(0.6, 1.3), 10));
        }
    } else if (random.chance(0.6)) {
        gauge["section"] = random.integer(0, plan.J - 1);
    }
    return gauge;
}

// A share of the feed, or all of it, goes on all the time.
void feedContinuously(Random& random, const Plan& plan, json& project) {
    const json& part = project["part"];
    const json& machine = project["machine"];
    const double o1 = machine["overrun_entry_mm"], o2 = machine["overrun_exit_mm"];
    const double B = project["wheel"]["width_mm"], L_p = part["length_mm"];
    const double dwell_s = machine["dwell_entry_s"], exitDwell_s = machine["dwell_exit_s"];
    for (int z = 0; z < plan.feedStages; ++z) {
        json& stage = project["cycle"]["stages"][z];
        if (random.chance(0.3)) {
            continue;
        }
        const double axial = stage["axial_feed_mm_min"];
        const double stroke_min =
            2 * (L_p - B + o1 + o2) / axial + (2 * dwell_s + exitDwell_s) / 60;
        const double feed = stage["radial_feed_mm"];
        const bool all = random.chance(0.3);
        const double share = all ? 1 : random.uniform(0.1, 0.9);
        stage["continuous_feed_mm_min"] =
            std::clamp(rounded(share * feed / stroke_min, 6), 1e-6, 10.0);
        stage["radial_feed_mm"] = all ? 0 : std::max(1e-5, rounded((1 - share) * feed, 5));
    }
}

// Limits of practice, and delays of up to some steps. Drawn apart, so that all else is as without.
void addPractice(std::uint64_t seed, bool traverse, json& project) {
    Random random(seed ^ 0x5bd1e995U);
    const double turn_s = 60 / project["machine"]["work_speed_rpm"].get<double>();
    const double most_s = traverse ? 30 : 6 * turn_s;
    if (random.chance(0.35)) {
        const double delay_s =
            random.chance(0.3) ? turn_s * random.integer(0, 4) : random.uniform(0, most_s, 3);
        const bool isOfMachine = seed % 3 == 0;
        project[isOfMachine ? "machine" : "gauge"][isOfMachine ? "gauge_delay_s" : "delay_s"] =
            delay_s;
    }
    if (random.chance(0.35)) {
        project["machine"]["feed_change_delay_s"] = random.uniform(0, most_s, 3);
    }
    if (random.chance(0.4)) {
        project["least_overlap"] = random.uniform(1, 4, 2);
    }
    if (random.chance(0.4)) {
        project["least_overlap_last"] = random.uniform(1, 8, 1);
    }
    if (random.chance(0.4)) {
        project["least_steps"] = random.integer(1, 9);
    }
}

// A keyway or two, or splines of an even number. Drawn apart, too.
void addGaps(std::uint64_t seed, json& project) {
    Random random(seed ^ 0x9747b28dU);
    if (!random.chance(0.15)) {
        return;
    }
    json& part = project["part"];
    json gaps = json::array();
    const int number = random.oneOf({1, 1, 2, 6});
    const double first = random.uniform(0, 360, 1);
    const double width = random.uniform(0.1, number == 6 ? 25 : 60, 1);
    for (int i = 0; i < number; ++i) {
        gaps.push_back({{"from_deg", rounded(std::fmod(first + 360.0 / number * i, 360), 4)},
                        {"width_deg", random.chance(0.1) ? 0 : width}});
    }
    json& gauge = project["gauge"];
    if (gauge.is_object() && gauge.value("rule", "min") == "max") {
        gauge["spans_gaps"] = random.chance(0.3);
    }
    if (gauge.is_null()) {
        project.erase("gauge");
    }
    // Every fourth radius must be left, so that there is a diameter to measure.
    const int K = part.value("radii_per_section", 36);
    std::vector<bool> inside(static_cast<std::size_t>(K));
    for (const json& gap : gaps) {
        for (int k = 0; k < K; ++k) {
            const double beyond =
                std::fmod(360.0 * k / K - gap["from_deg"].get<double>() + 720, 360);
            inside[k] = inside[k] || beyond < gap["width_deg"].get<double>();
        }
    }
    int ground = 0, across = 0;
    for (int k = 0; k < K; ++k) {
        ground += inside[k] ? 0 : 1;
        across += inside[k] || inside[(k + K / 2) % K] ? 0 : 1;
    }
    if (ground >= 4 && across > 0) {
        part["gaps"] = gaps;
    } else if (project.contains("gauge")) {
        project["gauge"].erase("spans_gaps");
    }
}

} // namespace

json randomProject(std::uint64_t seed) {
    Random random(seed);
    Plan plan = choosePlan(random);
    if (plan.traverse) { // drawn apart, so that shafts are as ever
        plan.internal = Random(seed ^ 0x7f4a7c16U).chance(0.3);
    }
    chooseFeeds(random, plan);
    json project = {{"format", "sparkout-project"},
                    {"version", 1},
                    {"title", "random " + std::to_string(seed)},
                    {"operation", plan.traverse ? "traverse" : "plunge"}};
    json part = partOf(random, plan);
    addProfile(random, plan, part);
    json machine = machineOf(random, plan);
    const double n = machine["work_speed_rpm"];
    project["material"] = materialOf(random);
    project["wheel"] = wheelOf(random, plan, part["diameter_mm"]);
    const double B = project["wheel"]["width_mm"];
    chooseLengths(random, plan, B, part, machine);
    const double L_p = part["length_mm"];
    json stages = stagesOf(random, plan, n, B, L_p);
    disturbStocks(random, plan, part, stages, n);
    project["part"] = part;
    project["machine"] = machine;
    const double gamma = chooseCompliance(random, plan, project);
    project["machine"]["compliance_mm_per_n"] = spread(random, plan, gamma);
    if (plan.last != LastStage::Feed) {
        completeSparkOut(random, plan, project, gamma, stages.back());
    }
    project["cycle"]["stages"] = stages;
    json gauge = gaugeOf(random, plan, L_p, gamma);
    if (plan.positionControl && random.chance(0.5)) { // the blank larger or smaller than expected
        const double touch = part["stock_mm"].get<double>() + plan.runout;
        gauge["datum_mm"] = std::max(0.001, rounded(touch + random.uniform(-0.02, 0.03), 4));
    }
    if (!gauge.empty() || random.chance(0.5)) {
        project["gauge"] = gauge;
    }
    if (plan.traverse && random.chance(0.5)) {
        project["machine"]["reversal_infeed"] = random.oneOf({"entry", "exit", "both"});
    }
    if (plan.traverse && random.chance(0.25)) {
        feedContinuously(random, plan, project);
    }
    if (!plan.traverse && (plan.J != 4 || random.chance(0.5))) {
        project["sections"] = plan.J;
    }
    Random worn(seed ^ 0x1c69b3f7U); // drawn apart, so that all else is as ever
    if (worn.chance(0.3)) {
        project["wheel"]["radius_wear_um"] = rounded(worn.uniform(0.5, 15), 2);
    }
    if (worn.chance(0.5)) {
        project["machine"]["wheel_speed_control"] =
            worn.oneOf({"constant_speed", "constant_revolutions"});
    }
    addPractice(seed, plan.traverse, project);
    addGaps(seed, project);
    if (plan.traverse) {
        Random again(seed ^ 0x2545f491U);
        if (again.chance(0.15)) {
            project["zone_sections"] = again.integer(2, 6);
        }
    }
    return project;
}

json withThreshold(json project, std::uint64_t seed) {
    Random random(seed ^ 0x51ed270bU);
    json& material = project["material"];
    material["force_law"] = "threshold";
    material["threshold_force_n_mm"] = rounded(std::exp(random.uniform(-3, 1.5)), 3);
    material["specific_force_mpa"] = rounded(std::exp(random.uniform(8, 12)), 0);
    if (random.chance(0.5)) {
        material["specific_tangential_force_mpa"] = rounded(std::exp(random.uniform(8, 12)), 0);
    }
    return project;
}

json withWheelRunout(json project, std::uint64_t seed) {
    Random random(seed ^ 0x2c1b3c6dU);
    json& machine = project["machine"];
    json runout = json::object();
    if (random.chance(0.6)) {
        runout["amplitude_um"] = random.uniform(0.05, 3, 2);
        if (random.chance(0.3)) {
            runout["lobes"] = random.integer(2, 5);
        }
    } else {
        machine["stiffness_n_um"] = {{"headstock", 60}, {"tailstock", 40}, {"wheel_head", 50}};
        if (random.chance(0.5)) {
            runout["unbalance_g_mm"] = random.uniform(1, 100, 1);
        } else {
            runout["balance_grade_mm_s"] = random.uniform(0.2, 2.5, 1);
            runout["rotor_mass_kg"] = random.uniform(1, 50, 1);
        }
        if (random.chance(0.5)) {
            machine["wheel_head_frequency_hz"] = random.integer(15, 400);
        }
    }
    if (random.chance(0.7)) {
        runout["phase_deg"] = random.uniform(0, 360, 1);
    }
    if (random.chance(0.3)) {
        machine["work_speed_variation"] = {{"percent", random.uniform(0, 20, 1)},
                                           {"period_s", random.uniform(1, 10, 1)}};
    }
    project["wheel"]["runout"] = runout;
    // Three to twelve waves a turn, and twelve radii for each of them, or of those of several
    // turns.
    const double speedAtOne = machine["work_speed_rpm"].get<double>() / runout.value("lobes", 1)
                              * std::numbers::pi * project["wheel"]["diameter_mm"].get<double>()
                              / 60'000;
    const double ratio = std::clamp(random.uniform(3, 12, 2), 1.1 / speedAtOne, 200 / speedAtOne);
    machine["wheel_speed_m_s"] = ratio * speedAtOne;
    int waves = static_cast<int>(std::round(ratio));
    for (int turns = 6; turns > 0; --turns) {
        const double whole = std::round(turns * ratio);
        waves = std::abs(turns * ratio - whole) < 0.051 ? static_cast<int>(whole) : waves;
    }
    json& part = project["part"];
    part["radii_per_section"] = std::max(12 * waves, part.value("radii_per_section", 36));
    if (part.contains("radii_um")) { // typed for another number of radii
        part.erase("radii_um");
        part["profile"] = "ellipse";
    }
    return project;
}
