#include "vulkan/execute/unit_input.h"

#include <cstring>

#include "vulkan/pipelines/params.h"

namespace weft::vk {
namespace {

void add_number(uint64_t number, std::vector<std::byte>& bytes) {
    const size_t old = bytes.size();
    bytes.resize(old + sizeof number);
    std::memcpy(bytes.data() + old, &number, sizeof number);
}

// Compares the inputs of a unit in this frame with the inputs of the last run of the unit, one part after the
// other. `last` contains the inputs of the last run. An object that was made without `last` compares nothing.
class Comparison {
 public:
    Comparison() = default;
    explicit Comparison(std::span<const std::byte> last) : last_(last), compares_(true) {}

    // Compares the bytes that were added since the last call of this function. These bytes are one part of
    // the inputs. `name` is a function that returns the name of the part. Its argument is the index of the
    // first byte of the part that differs.
    template <class Name>
    void part(const std::vector<std::byte>& bytes, const Name& name) {
        if (compares_ && found_.empty())
            for (size_t at = seen_; at < bytes.size(); ++at)
                if (at >= last_.size() || bytes[at] != last_[at]) {
                    found_ = name(at - seen_);
                    break;
                }
        seen_ = bytes.size();
    }
    [[nodiscard]] std::string found() const { return found_; }

 private:
    std::span<const std::byte> last_;
    bool compares_ = false;
    size_t seen_ = 0;
    std::string found_;
};

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

// Returns the name of the member of Params at this byte.
std::string member_at(const PassDecl& pass, size_t at) {
    for (const ParamWrite& write : pass.params)
        if (at >= write.offset_bytes && at < write.offset_bytes + size_t{4} * write.components)
            return "member " + quoted(write.member) + " of Params of pass " + quoted(pass.name);
    return "Params of pass " + quoted(pass.name);
}

// Returns the ranges of the constants in set 0 whose values the draw source knows. If the pass reads its view
// from a buffer, the constants of the view are left out, because the pass reads this buffer like any other
// buffer.
std::vector<FrameRange> known_ranges(const PassDecl& pass, const PreparedPass& prepared) {
    std::vector<FrameRange> ranges = prepared.frame_ranges;
    if (pass.view_use != kNoId)
        std::erase_if(ranges, [](const FrameRange& range) { return range.binding == kViewBinding; });
    return ranges;
}

// Adds the constants that the draws of the pass read, and the versions of its draw lists. Returns false if
// the constants or one of the draw lists may change in every frame.
bool add_draws(const UnitInputContext& context, const PassDecl& pass, const PreparedPass& prepared,
               std::vector<std::byte>& bytes, Comparison& comparison) {
    const DrawSource* draws = context.objects.draws;
    for (const std::string& view : pass.drawn_views()) {
        if (prepared.layout.declares[kFrameSet] &&
            !draws->add_frame_bytes(context.slot, view, known_ranges(pass, prepared), bytes))
            return false;
        comparison.part(bytes, [&](size_t) {
            return "a constant of the frame or of view " + quoted(view) + " that pass " + quoted(pass.name) +
                   " reads";
        });
    }
    for (const std::string& list : pass.draw_lists) {
        const std::optional<uint64_t> version = draws->list_version(list);
        if (!version) return false;
        add_number(*version, bytes);
        comparison.part(bytes, [&](size_t) { return "draw list " + quoted(list); });
    }
    return true;
}

// Adds the versions of the imports that the pass reads. Returns false if one of these imports has no version.
bool add_imports(const UnitInputContext& context, const PassDecl& pass, std::vector<std::byte>& bytes,
                 Comparison& comparison) {
    for (const UseDecl& use : pass.uses) {
        const ResourceDecl& resource = context.objects.plan.graph.resources[use.resource];
        if (resource.lifetime != ResourceLifetime::imported || !use.wakes) continue;
        const auto version = context.frame.import_versions.find(resource.name);
        if (version == context.frame.import_versions.end()) return false;
        add_number(version->second, bytes);
        comparison.part(bytes, [&](size_t) { return "import " + quoted(resource.name); });
    }
    return true;
}

// Adds the areas of the live images that the pass uses. A change of the area changes what the pass has to
// write, also if its Params do not change.
void add_areas(const UnitInputContext& context, const PassDecl& pass, std::vector<std::byte>& bytes,
               Comparison& comparison) {
    const FramePlan& plan = context.objects.plan;
    for (const UseDecl& use : pass.uses) {
        if (plan.graph.resources[use.resource].area == kNoId) continue;
        const Extent3D& area = context.objects.areas.area(use.resource);
        add_number(uint64_t{area.width} << 32 | area.height, bytes);
        comparison.part(
            bytes, [&](size_t) { return "the area of " + quoted(plan.graph.resources[use.resource].name); });
    }
}

void add_inputs(const UnitInputContext& context, Position position, UnitInput& input,
                Comparison& comparison) {
    if (!input) return;
    const FramePlan& plan = context.objects.plan;
    const PassId id = plan.schedule.order[position];
    const PassDecl& pass = plan.graph.passes[id];
    std::vector<std::byte>& bytes = *input;
    const size_t old = bytes.size();
    bytes.resize(old + pass.params_bytes);
    // The values of Params that tell whether results of units are valid are left out here
    // (FrameValues::validity is null). These values need no comparison: when the results of a unit become
    // valid, that unit has run, and its run has woken the passes that read the results.
    write_params(plan.graph, id, {context.frame, context.resources, context.objects.areas},
                 std::span(bytes).subspan(old));
    comparison.part(bytes, [&](size_t at) { return member_at(pass, at); });
    add_areas(context, pass, bytes, comparison);
    // Passes without a shader have no Params, so the value of a clear is added here.
    for (const float channel : pass.clear) {
        uint32_t bits = 0;
        std::memcpy(&bits, &channel, sizeof bits);
        add_number(bits, bytes);
    }
    comparison.part(bytes, [&](size_t) { return "the clear value of pass " + quoted(pass.name); });
    const bool known = add_draws(context, pass, context.objects.passes[position], bytes, comparison) &&
                       add_imports(context, pass, bytes, comparison);
    if (!known) input.reset();
}

}  // namespace

void add_unit_input(const UnitInputContext& context, Position position, UnitInput& input) {
    Comparison none;
    add_inputs(context, position, input, none);
}

std::string changed_input(const UnitInputContext& context, std::span<const Position> positions,
                          std::span<const std::byte> last) {
    UnitInput input(std::in_place);
    Comparison comparison(last);
    for (const Position position : positions) add_inputs(context, position, input, comparison);
    return comparison.found();
}

}  // namespace weft::vk
