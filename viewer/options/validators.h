// Purpose: validators of flag values for the library CLI11. The message of each validator names the expected
// values. The validators of numbers also rewrite the number in a form that CLI11 reads in the same way in
// every locale.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viewer/options/numbers.h"

namespace CLI {
class Validator;
}

namespace weft::viewer {

inline constexpr uint64_t kMostSeed = 0xFFFFFFFF;
inline constexpr uint64_t kMostLights = 65'536;
// The largest value of --probe-rounds, which says how often each probe is lit before the first frame.
inline constexpr uint64_t kMostProbeRounds = 64;
inline constexpr uint64_t kMostQueues = 4;
inline constexpr NumberRange kTimeout{0.001, 3600, "s"};

[[nodiscard]] CLI::Validator size_validator();
[[nodiscard]] CLI::Validator frames_validator();
[[nodiscard]] CLI::Validator param_validator();
[[nodiscard]] CLI::Validator turns_validator();
[[nodiscard]] CLI::Validator import_validator();
[[nodiscard]] CLI::Validator env_validator();
[[nodiscard]] CLI::Validator plot_validator();
[[nodiscard]] CLI::Validator folder_validator();
[[nodiscard]] CLI::Validator number_in(const NumberRange& range);
[[nodiscard]] CLI::Validator fraction_in(const NumberRange& range);
[[nodiscard]] CLI::Validator whole_number_in(uint64_t least, uint64_t most);
[[nodiscard]] CLI::Validator choice_validator(std::vector<std::string> choices);

}  // namespace weft::viewer
