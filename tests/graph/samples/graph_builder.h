// Purpose: builds a ResolvedGraph by hand, for tests of the stages that follow resolve(). A test adds passes
// in program order, and a read sees the last write before it. build() sorts passes and resources by name and
// renumbers their ids, as resolve() does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::test {

struct BuilderUse {
    std::string port;
    // Id of the resource, as returned by image() or buffer() of the builder.
    ResourceId resource = kNoId;
    Access access = Access::none;
    // Part of the resource that the pass accesses; by default the whole resource.
    std::optional<SubresourceRange> range;
    uint32_t binding = kNoId;
};

[[nodiscard]] SubresourceRange one_cell(uint32_t mip, uint32_t layer = 0);

class GraphBuilder {
 public:
    ResourceId image(std::string name, Format format = Format::r32u, uint32_t side_px = 16, uint32_t mips = 1,
                     uint32_t layers = 1);
    ResourceId buffer(std::string name, uint64_t size_bytes = 1024);
    // Divides a buffer into pieces at these offsets. A pass that uses piece i has the range one_cell(0, i).
    // Call cut() before a pass uses the buffer.
    void cut(ResourceId buffer, std::vector<uint64_t> cuts_bytes) {
        graph_.resources[buffer].cuts_bytes = std::move(cuts_bytes);
    }
    // Returns the declaration of the resource. A test can change properties in it for which the builder has
    // no function, such as the number of samples. Call edit() before a pass uses the resource.
    [[nodiscard]] ResourceDecl& edit(ResourceId id) { return graph_.resources[id]; }
    // Changes the resource to an import with these states before and after the frame.
    void import_as(ResourceId resource, const AccessState& entry, const AccessState& exit);
    // Marks the import as shared between all queue families (VK_SHARING_MODE_CONCURRENT).
    void make_concurrent(ResourceId import);
    // Makes a ring of the resource "x": adds the resources "x[-1]", "x[-2]" and so on, which are the content
    // of "x" in the last `history` frames. Returns all resources of the ring, newest first. If `history` is
    // 0, "x" only keeps its content from frame to frame.
    std::vector<ResourceId> ring(ResourceId resource, uint32_t history);
    void set_output(ResourceId resource) { graph_.output = resource; }

    // Adds a list of views, which passes may draw. The program gives their matrices.
    void add_view_list(std::string name, uint32_t count) {
        ViewListDecl& list = graph_.views.emplace_back();
        list.name = std::move(name);
        list.count = count;
    }

    // Adds a pass. Its attachments follow from the accesses in `uses`. The returned reference is valid until
    // the next call of the builder.
    PassDecl& pass(std::string name, PassKind kind, const std::vector<BuilderUse>& uses);
    PassDecl& compute(std::string name, const std::vector<BuilderUse>& uses) {
        return pass(std::move(name), PassKind::compute, uses);
    }
    // Adds an edge: pass `to` must run after pass `from`, even if they share no resource.
    void after(const std::string& from, const std::string& to);

    [[nodiscard]] const ResourceDecl& resource(ResourceId id) const { return graph_.resources[id]; }
    [[nodiscard]] ResolvedGraph build() const;

 private:
    ResolvedGraph graph_;
    std::vector<std::pair<std::string, std::string>> after_;
};

}  // namespace weft::test
