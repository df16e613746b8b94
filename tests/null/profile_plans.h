// Purpose: random frames with all features, half of them from texts, planned for every device profile on one
// to four queues: a seed says everything.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft::test {

// Ten thousand graphs take minutes: only when asked for.
inline bool extended() {
    return std::getenv("WEFT_EXTENDED") != nullptr;
}

struct ProfilePlan {
    FramePlan plan;
    std::string profile;  // its file's name
    bool from_text = false;
    bool left_out = false;  // conditions left something out
};

class ProfilePlans {
 public:
    ProfilePlans();  // reads framework/profiles/

    // Texts have even seeds. One that resolve() rejects is a failure of the test, and the plan is empty.
    [[nodiscard]] ProfilePlan make(uint32_t seed, uint32_t max_passes = 60) const;
    [[nodiscard]] size_t count() const { return profiles_.size(); }

 private:
    std::vector<std::pair<std::string, DeviceProfile>> profiles_;
};

}  // namespace weft::test
