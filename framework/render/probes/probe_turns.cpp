#include "render/probes/probe_turns.h"

#include <algorithm>
#include <tuple>

namespace weft::render {

ProbeTurns::ProbeTurns(std::vector<glm::vec3> places, uint32_t most_turns) : most_turns_(most_turns) {
    for (const glm::vec3& place : places) probes_.push_back({place});
}

std::vector<uint32_t> ProbeTurns::next(const glm::vec3& camera) {
    struct Candidate {
        uint64_t turns = 0;
        float distance2 = 0;
        uint32_t probe = 0;
    };
    std::vector<Candidate> waiting;
    for (uint32_t i = 0; i < probes_.size(); ++i) {
        if (probes_[i].may_run_from > frame_) continue;
        const glm::vec3 way = probes_[i].position - camera;
        waiting.push_back({probes_[i].turns, glm::dot(way, way), i});
    }
    const auto before = [](const Candidate& a, const Candidate& b) {
        return std::tie(a.turns, a.distance2, a.probe) < std::tie(b.turns, b.distance2, b.probe);
    };
    const auto count = static_cast<std::ptrdiff_t>(std::min<size_t>(most_turns_, waiting.size()));
    std::ranges::partial_sort(waiting, waiting.begin() + count, before);
    std::vector<uint32_t> chosen;
    for (auto next = waiting.begin(); next != waiting.begin() + count; ++next) {
        chosen.push_back(next->probe);
        ++probes_[next->probe].turns;
        probes_[next->probe].may_run_from = frame_ + kLeastFramesBetween;
    }
    ++frame_;
    return chosen;
}

}  // namespace weft::render
