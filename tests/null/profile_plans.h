// Purpose: random frames with all features, half of them from texts, planned for every device profile on one
// to four queues; the seed determines everything.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "weft/device_profile.h"
#include "weft/plan.h"

namespace weft::test {

// Ten thousand graphs take minutes, so they run only on request.
inline bool extended() {
    return std::getenv("WEFT_EXTENDED") != nullptr;
}

struct ProfilePlan {
    FramePlan plan;
    std::string profile;  // file name of the profile
    bool from_text = false;
    bool left_out = false;  // conditions removed a pass or changed an input
};

class ProfilePlans {
 public:
    ProfilePlans();  // reads framework/profiles/

    // Texts have even seeds. If resolve() rejects one, the test fails and the plan is empty.
    [[nodiscard]] ProfilePlan make(uint32_t seed, uint32_t max_passes = 60) const;
    [[nodiscard]] size_t count() const { return profiles_.size(); }

 private:
    std::vector<std::pair<std::string, DeviceProfile>> profiles_;
};

}  // namespace weft::test
