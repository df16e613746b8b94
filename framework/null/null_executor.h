// Purpose: runs a plan without a GPU, in one of the orders that its barriers and semaphores allow, for
// example with every command delayed as long as possible. Every subresource has one 64-bit value at its place
// in the plan's memory. A pass writes hashes of all values that it reads. So two runs have an equal value
// only if all values from which it was computed were equal, too. Memory behaves as in Vulkan (1.3
// specification, chapter "Synchronization and Cache Control" and appendix "Memory Model"): other accesses see
// a write only after a dependency has made it available and visible. A read gets poison if no dependency
// orders it after the write, if other data has replaced the content, or if the layout or the owning queue
// family is wrong. Poison is a unique value that spreads to all values computed from it. Errors: none; a
// wrong plan gives wrong values, and `faults` describes the first causes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Selects one of the execution orders that the plan allows.
enum class NullOrder : uint8_t {
    recorded,  // Commands run in submission order.
    delayed,   // Every command runs as late as possible, starting from the last one.
    shuffled,  // Commands run in a pseudo-random order, made from the seed.
};

// Index: frame, then rest unit (passes that run together or not at all). 1: the passes of the unit do not run
// in this frame; 0: they run. A unit runs in each frame that the list does not contain.
using RestChoice = std::vector<std::vector<uint8_t>>;

// Index: frame, then PassId. Value: a number that stands for all inputs of the pass from outside the graph,
// for example its parameters. If the number differs, the pass writes different values. A pass that the list
// does not contain has the number 0.
using InputChoice = std::vector<std::vector<uint32_t>>;

// Index: frame. Value: the rounds of groups that run in the frame, in this order, as numbers of rest units
// (see GroupDecl). A round is one copy of all passes of a group. In a frame that the list does not contain,
// all rounds that do not rest run in the order of their numbers.
using RoundOrder = std::vector<std::vector<uint32_t>>;

// Index: frame. The switches that are on in the frame. In a frame that the list does not contain, all are on.
using SwitchChoice = std::vector<Combination>;

struct NullOptions {
    uint32_t frames = 3;
    // Selects the order if `order` is `shuffled`. For a write that may happen in several stages, the seed
    // also selects the stage.
    uint64_t seed = 0;
    NullOrder order = NullOrder::shuffled;
    RestChoice resting = {};
    InputChoice inputs = {};
    RoundOrder rounds = {};
    SwitchChoice switches = {};
};

// A number that stands for the content of a subresource or buffer. Equal numbers mean equal content; 0 means
// undefined content.
using CellValue = uint64_t;
inline constexpr CellValue kUndefinedValue = 0;

// The value of one subresource seen by an observer: a pass with side effects, the owner of an import after a
// frame (pass kNoId), the program that reads a persistent resource between frames (pass kNoId), or a reader
// of a persistent resource after the last frame (pass kNoId).
struct ObservedCell {
    uint32_t frame = 0;
    PassId pass = kNoId;
    uint32_t use = 0;  // Index into PassDecl::uses of the observing pass; 0 without a pass.
    ResourceId resource = kNoId;
    SubresourceRange range;  // The subresource: one mip of one layer of one aspect.
    CellValue value = kUndefinedValue;
};

struct NullRun {
    std::vector<ObservedCell> observed;  // The observed values, sorted by all members except `value`.
    std::vector<std::string> faults;     // The first few causes of poison, in order of occurrence.
};

[[nodiscard]] NullRun run_null(const FramePlan& plan, const NullOptions& options = {});

// Computes the result that every correct plan of the graph has. It runs the passes one after another with
// separate memory for every resource, and for every round of a group, so that every read sees the version
// given by the graph. It uses only the declarations in the graph, and no plan.
[[nodiscard]] NullRun run_reference(const ResolvedGraph& graph, const LiveGraph& live, uint32_t frames = 3,
                                    const RestChoice& resting = {}, const InputChoice& inputs = {},
                                    const RoundOrder& rounds = {}, const SwitchChoice& switches = {});

// Returns a text for each observed value of `wanted` that `found` lacks or has with another value. Undefined
// values in `wanted`, and values that only `found` has, are not compared.
[[nodiscard]] std::vector<std::string> differences(const ResolvedGraph& graph, const NullRun& wanted,
                                                   const NullRun& found);

}  // namespace weft
