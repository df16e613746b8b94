// Purpose: makes plans of random frames with all features, for all device profiles and one to four queues.
// Half of the frames come from graph texts. The seed determines everything.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft::test {

// Returns true if WEFT_EXTENDED asks for the complete tests. Ten thousand graphs take minutes, so they run
// only on request.
inline bool extended() {
    return std::getenv("WEFT_EXTENDED") != nullptr;
}

struct ProfilePlan {
    FramePlan plan;
    // File name, without extension, of the device profile that the plan is made for.
    std::string profile;
    bool from_text = false;
    // True if a false condition (`if`) in the text removed a pass or changed an input.
    bool omitted = false;
};

class ProfilePlans {
 public:
    // Reads all device profiles of framework/profiles/.
    ProfilePlans();

    // Makes the plan of a random frame. Even seeds make the frame from a text. If resolve() rejects the text,
    // the test fails and the plan is empty.
    [[nodiscard]] ProfilePlan make(uint32_t seed, uint32_t max_passes = 60) const;
    [[nodiscard]] size_t count() const { return profiles_.size(); }
    // Returns the profile for a seed.
    [[nodiscard]] const DeviceProfile& profile(uint32_t seed) const {
        return profiles_[seed / 2 % profiles_.size()].second;
    }

 private:
    std::vector<std::pair<std::string, DeviceProfile>> profiles_;
};

}  // namespace weft::test
