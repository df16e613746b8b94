#include "graph/resolve/fill/find_draw_commands.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

constexpr uint64_t kIndexedCommandBytes = 20;   // Size of DrawCommand: five 32-bit words.
constexpr uint64_t kVerticesCommandBytes = 16;  // Size of DrawVerticesCommand: four 32-bit words.
constexpr uint64_t kDrawCountBytes = 4;
constexpr uint32_t kMaterialSet = 2;  // Descriptor set with the material of an object.

class DrawCommandFinder {
 public:
    DrawCommandFinder(const Declared& declared, const VersionedGraph& graph, PassId pass,
                      Dispatches& dispatches, PassReporter& report)
        : declared_(declared),
          graph_(graph),
          bound_(graph.passes[pass]),
          desc_(*declared.expansion.passes[pass].desc),
          pass_(pass),
          dispatch_(dispatches.passes[pass]),
          suspects_(dispatches.suspects),
          report_(report) {}

    void run() {
        const auto commands = find(&PortDraft::is_indirect), count = find(&PortDraft::is_draw_count);
        // If a port is missing, bind() has already reported an error.
        if (commands == kNoId || (desc_.draw_count && count == kNoId)) return;
        dispatch_.draw_commands_use = commands;
        dispatch_.draw_count_use = count;
        if (suspects_.shapes[bound_.uses[commands].resource]) return;
        if (!check_commands(bound_.uses[commands])) return;
        if (count == kNoId || suspects_.shapes[bound_.uses[count].resource]) return;
        check_count(bound_.uses[count]);
    }

 private:
    uint32_t find(bool PortDraft::*role) const {
        const auto port = std::ranges::find_if(bound_.ports, role);
        return port == bound_.ports.end() ? uint32_t{kNoId}
                                          : static_cast<uint32_t>(port - bound_.ports.begin());
    }
    [[nodiscard]] bool draws_list() const { return !bound_.draw_lists.empty(); }
    [[nodiscard]] std::string pass_text() const { return "pass " + quote(declared_.pass_name(pass_)); }

    void error(SourceLoc loc, const char* code, const std::string& message, const std::string& help) {
        add_help(report_.error(pass_, loc, code, message), help);
    }

    // Checks that a use is a buffer of whole numbers with at least `wanted_bytes`. For the message, `holds`
    // names the data that the pass reads from the buffer, and `needs` names the part of the graph that needs
    // these bytes.
    bool check_buffer(const UseDecl& use, const std::string& holds, uint64_t wanted_bytes,
                      const std::string& needs, const std::string& help) {
        const ResourceDecl& resource = graph_.resources[use.resource];
        const bool buffer = resource.kind == ResourceKind::buffer;
        const bool floats = holds_floats(declared_.shapes, use.resource);
        const uint64_t bytes = used_bytes(resource, use).size_bytes;
        if (buffer && !floats && bytes >= wanted_bytes) return true;
        error(use.loc, "W114",
              pass_text() + " reads its " + holds + " from " + quote(range_of(resource, use.range)) +
                  (floats   ? std::string(", whose elements are floats")
                   : buffer ? ", which has " + std::to_string(bytes) + " bytes, but " + needs + " " +
                                  std::to_string(wanted_bytes)
                            : ", which is an image"),
              help);
        return false;
    }

    bool check_commands(const UseDecl& use) {
        const uint64_t bytes = used_bytes(graph_.resources[use.resource], use).size_bytes;
        if (!draws_list()) {
            dispatch_.most_draws = count_commands(bytes, kVerticesCommandBytes);
            return desc_.draws_without_list() &&
                   check_buffer(use, "draw commands", kVerticesCommandBytes, "a command needs",
                                "use a buffer of commands: { \"buffer\": \"DrawVerticesCommand\", "
                                "\"count\": 16 }");
        }
        const std::string& list = bound_.draw_lists.front();
        const auto import = declared_.input.imports.imports.find(list);
        // The error that the program does not offer the list was already reported.
        if (import == declared_.input.imports.imports.end()) return false;
        if (desc_.draw_count) dispatch_.most_draws = count_commands(bytes, kIndexedCommandBytes);
        const uint64_t draws = desc_.draw_count ? 1 : import->second.draws;
        return check_buffer(use, "draw commands", draws * kIndexedCommandBytes,
                            "the " + std::to_string(draws) + " draws of " + quote(list) + " need",
                            "use a buffer with one command for each draw: { \"buffer\": \"DrawCommand\", "
                            "\"count\": \"" +
                                list + "Draws\" }");
    }

    static uint32_t count_commands(uint64_t bytes, uint64_t command_bytes) {
        return static_cast<uint32_t>(std::min<uint64_t>(bytes / command_bytes, UINT32_MAX));
    }

    void check_count(const UseDecl& use) {
        if (!check_buffer(use, "number of draws", kDrawCountBytes, "the number needs",
                          "use a buffer of one word: { \"buffer\": \"u32\", \"count\": 1 }"))
            return;
        const DeviceProfile& profile = declared_.input.profile;
        if (!profile.draw_indirect_count) {
            error(use.loc, "W187",
                  pass_text() + " reads its number of draws from a buffer, which the device does not support",
                  "remove \"count\", and set instance_count to 0 in the commands that the GPU shall skip");
            return;
        }
        if (dispatch_.most_draws > profile.max_draw_indirect_count) {
            error(bound_.uses[dispatch_.draw_commands_use].loc, "W114",
                  pass_text() + " can execute up to " + std::to_string(dispatch_.most_draws) +
                      " draw commands; the device allows at most " +
                      std::to_string(profile.max_draw_indirect_count),
                  "use a smaller buffer, or select a part of it with .range(a..b)");
            return;
        }
        if (draws_list()) check_list_with_count(use.loc);
    }

    // If a buffer contains the number of draws, one indirect draw call draws the whole list. So all draws
    // need the same state: between the draws of one call, Weft cannot change the material, the culled face or
    // the pipeline.
    void check_list_with_count(SourceLoc loc) {
        const std::string& list = bound_.draw_lists.front();
        const std::string cannot =
            pass_text() + " cannot draw " + quote(list) + " with a number of draws in a buffer: ";
        if (desc_.state.cull != CullMode::none)
            return error(loc, "W195",
                         cannot +
                             "\"cull\" is not \"none\", so mirrored and double-sided objects "
                             "need their own state",
                         "write \"state\": { \"cull\": \"none\" }, or remove \"count\"");
        if (declared_.input.imports.imports.at(list).variants.size() > 1)
            return error(loc, "W195", cannot + "the objects of this list need different pipelines",
                         "draw another list, or remove \"count\"");
        const ShaderInterface* shader = declared_.expansion.passes[pass_].shader;
        if (shader && std::ranges::any_of(shader->bindings, [](const ShaderBinding& binding) {
                return binding.set == kMaterialSet;
            }))
            error(loc, "W195", cannot + "the shader reads materials, which Weft binds for each object",
                  "use a shader without descriptor set 2, or remove \"count\"");
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    const BoundPass& bound_;
    const PassDesc& desc_;
    PassId pass_;
    PassDispatch& dispatch_;
    const Suspects& suspects_;
    PassReporter& report_;
};

}  // namespace

bool holds_floats(const Shapes& shapes, ResourceId resource) {
    const ResourceDesc* desc = shapes.origins[resource].desc;
    if (desc == nullptr || !desc->is_buffer) return false;
    return desc->element == "f32" || desc->element == "mat4" || desc->element.starts_with("vec");
}

void find_draw_commands(const Declared& declared, const VersionedGraph& graph, PassId pass,
                        Dispatches& dispatches, PassReporter& report) {
    DrawCommandFinder(declared, graph, pass, dispatches, report).run();
}

}  // namespace weft
