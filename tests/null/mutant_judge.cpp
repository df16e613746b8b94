#include "tests/null/mutant_judge.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>

#include "null/null_executor.h"
#include "weft/check/check_plan.h"

namespace weft::test {
namespace {

// Each entry: number of frames, seed, order.
const std::array<NullOptions, 4> kJudgedOrders{{{3, 0, NullOrder::delayed},
                                                {3, 1, NullOrder::recorded},
                                                {3, 2, NullOrder::shuffled},
                                                {3, 3, NullOrder::shuffled}}};
// Number of frames that a plan with rest units or switches runs.
constexpr uint32_t kRestFrames = 5;

// Returns the rounds of all groups that run, in a random order.
std::vector<uint32_t> shuffled_rounds(const FramePlan& plan, const std::vector<uint8_t>& rests,
                                      std::mt19937& random) {
    std::vector<uint32_t> rounds;
    for (const GroupDecl& group : plan.graph.groups)
        for (uint32_t unit = group.first_unit; unit < group.first_unit + group.rounds; ++unit)
            if (rests[unit] == 0) rounds.insert(rounds.begin() + random() % (rounds.size() + 1), unit);
    return rounds;
}

class Judge {
 public:
    explicit Judge(const FramePlan& plan) {
        const uint32_t units = plan.graph.rest_unit_count;
        std::mt19937 random(units);
        for (NullOptions options : kJudgedOrders) {
            // All units run in frame 0. In the other frames, a random half of them rests.
            for (uint32_t frame = 0; units > 0 && frame < kRestFrames; ++frame) {
                std::vector<uint8_t>& rests = options.resting.emplace_back(units);
                for (uint8_t& unit : rests) unit = frame > 0 && random() % 2 == 0 ? 1 : 0;
                options.rounds.push_back(shuffled_rounds(plan, rests, random));
            }
            // The switches are on in frame 0. In the other frames, random ones are on.
            for (uint32_t frame = 0; !plan.graph.switches.empty() && frame < kRestFrames; ++frame)
                options.switches.push_back(frame == 0 ? kAllSwitchesOn : random() % kCombinationCount);
            if (units > 0 || !plan.graph.switches.empty()) options.frames = kRestFrames;
            runs_.push_back({options, run_reference(plan.graph, plan.live, options.frames, options.resting,
                                                    options.inputs, options.rounds, options.switches)});
        }
    }

    // Runs the plan and returns a text about the first difference from the expected result. Returns an empty
    // text if there is no difference.
    [[nodiscard]] std::string broken(const FramePlan& plan) const {
        for (const JudgedRun& run : runs_) {
            const NullRun found = run_null(plan, run.options);
            const std::vector<std::string> different = differences(plan.graph, run.wanted, found);
            if (!different.empty())
                return different.front() + "; " + (found.faults.empty() ? "" : found.faults.front());
        }
        return {};
    }

 private:
    struct JudgedRun {
        NullOptions options;
        NullRun wanted;
    };
    std::vector<JudgedRun> runs_;
};

}  // namespace

// Counts the mutants that the checker rejects and those that give wrong results. The checker is fast and
// judges all chosen mutants. The null executor runs only the mutants that the checker accepts, and every
// `stride`th of the others.
void judge_mutants(const FramePlan& plan, uint32_t stride, Tallies& tallies, uint32_t every) {
    const Judge judge(plan);
    uint32_t turn = 0, number = 0;
    for_each_mutant(plan, [&](const Mutant& mutant) {
        if (number++ % every != 0) return;
        Tally& tally = tallies.at(static_cast<size_t>(mutant.kind));
        ++tally.all;
        const bool caught = !check_plan(mutant.plan).empty();
        tally.caught += caught ? 1 : 0;
        if (caught && turn++ % stride != 0) return;
        ++tally.asked;
        const std::string why = judge.broken(mutant.plan);
        tally.broken += why.empty() ? 0 : 1;
        if (caught) return;
        if (why.empty()) {
            ++tally.redundant;
            if (std::getenv("WEFT_SHOW_REDUNDANT") != nullptr)
                std::cout << plan.graph.name << ": redundant: " << mutant.text << "\n";
            return;
        }
        ++tally.missed;
        ADD_FAILURE() << mutant.text << "\n" << why;
    });
}

void print(const Tallies& tallies) {
    constexpr std::array<const char*, kMutantKinds> kNames{"barriers removed",
                                                           "barriers weakened by a bit",
                                                           "the prologue's barriers weakened by a bit",
                                                           "waits removed",
                                                           "transfer halves removed",
                                                           "owners left out of an alias transition",
                                                           "scopes parted",
                                                           "barriers recorded in other frames",
                                                           "shared barriers moved between rounds",
                                                           "barriers without their last layer, mip or piece"};
    for (size_t k = 0; k < tallies.size(); ++k) {
        const Tally& t = tallies[k];
        const auto percent = [](uint32_t part, uint32_t all) { return all == 0 ? 0.0 : 100.0 * part / all; };
        std::cout << kNames[k] << ": " << t.all << ", the checker catches " << percent(t.caught, t.all)
                  << " %, redundant to both " << percent(t.redundant, t.all) << " %, missed " << t.missed
                  << "; of " << t.asked << " run, " << t.broken << " gave something else\n";
    }
}

}  // namespace weft::test
