// Purpose: builds ResolvedGraphs by hand, for tests of the stages after resolve(). Passes are given in
// program order; a read sees the last write before it in that order. build() sorts by name and remaps ids, as
// resolve() does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::test {

struct BuilderUse {
    std::string port;
    ResourceId resource = kNoId;  // as returned by the builder
    Access access = Access::none;
    std::optional<SubresourceRange> range;  // default: the whole resource
    uint32_t binding = kNoId;
};

[[nodiscard]] SubresourceRange one_cell(uint32_t mip, uint32_t layer = 0);

class GraphBuilder {
 public:
    ResourceId image(std::string name, Format format = Format::r32u, uint32_t side_px = 16, uint32_t mips = 1,
                     uint32_t layers = 1);
    ResourceId buffer(std::string name, uint64_t size_bytes = 1024);
    // For properties that the other functions do not cover: samples, other extents. Call this before the
    // first use.
    [[nodiscard]] ResourceDecl& edit(ResourceId id) { return graph_.resources[id]; }
    // Changes a resource to an import.
    void import_as(ResourceId resource, const AccessState& entry, const AccessState& exit);
    // Shares the import between all queue families.
    void make_concurrent(ResourceId import);
    // Changes a resource to the newest one of a ring and adds the older ones: "x[-1]" and so on. Returns them
    // ordered by age. Without history the content is kept.
    std::vector<ResourceId> ring(ResourceId resource, uint32_t history);
    void set_output(ResourceId resource) { graph_.output = resource; }

    // Attachments are derived from the accesses. The returned reference may be used until the next call.
    PassDecl& pass(std::string name, PassKind kind, const std::vector<BuilderUse>& uses);
    PassDecl& compute(std::string name, const std::vector<BuilderUse>& uses) {
        return pass(std::move(name), PassKind::compute, uses);
    }
    // `to` must run after `from`, without a shared resource.
    void after(const std::string& from, const std::string& to);

    [[nodiscard]] const ResourceDecl& resource(ResourceId id) const { return graph_.resources[id]; }
    [[nodiscard]] ResolvedGraph build() const;

 private:
    ResolvedGraph graph_;
    std::vector<std::pair<std::string, std::string>> after_;
};

}  // namespace weft::test
