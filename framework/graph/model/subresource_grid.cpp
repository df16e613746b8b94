#include "graph/model/subresource_grid.h"

#include <algorithm>

namespace weft {
namespace {

void sort_unique(std::vector<uint32_t>& cuts) {
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
}

uint32_t index_of(const std::vector<uint32_t>& cuts, uint32_t value) {
    return static_cast<uint32_t>(std::lower_bound(cuts.begin(), cuts.end(), value) - cuts.begin());
}

// A rectangle of grid cells: layers [layer, layer_end) and mips [mip, mip_end), both counted in cells.
struct Run {
    uint32_t layer = 0;
    uint32_t layer_end = 0;
    uint32_t mip = 0;
    uint32_t mip_end = 0;
};

}  // namespace

SubresourceGrid::SubresourceGrid(const ResourceDecl& resource, const std::vector<SubresourceRange>& ranges) {
    const SubresourceRange whole = resource.whole();
    mip_cuts_ = {whole.mip, whole.mip + whole.mips};
    layer_cuts_ = {whole.layer, whole.layer + whole.layers};
    aspects_ = whole.aspects;
    for (const SubresourceRange& range : ranges) {
        mip_cuts_.insert(mip_cuts_.end(), {range.mip, range.mip + range.mips});
        layer_cuts_.insert(layer_cuts_.end(), {range.layer, range.layer + range.layers});
    }
    sort_unique(mip_cuts_);
    sort_unique(layer_cuts_);
}

std::vector<uint32_t> SubresourceGrid::cells_of(const SubresourceRange& range) const {
    const uint32_t mip_end = index_of(mip_cuts_, range.mip + range.mips);
    const uint32_t layer_end = index_of(layer_cuts_, range.layer + range.layers);
    std::vector<uint32_t> cells;
    for (uint32_t layer = index_of(layer_cuts_, range.layer); layer < layer_end; ++layer)
        for (uint32_t mip = index_of(mip_cuts_, range.mip); mip < mip_end; ++mip)
            cells.push_back(layer * mip_count() + mip);
    return cells;
}

std::vector<SubresourceRange> SubresourceGrid::merge(const std::vector<uint32_t>& cells) const {
    std::vector<Run> runs;
    for (const uint32_t cell : cells) {
        const uint32_t layer = cell / mip_count(), mip = cell % mip_count();
        if (!runs.empty() && runs.back().layer == layer && runs.back().mip_end == mip)
            ++runs.back().mip_end;
        else
            runs.push_back({layer, layer + 1, mip, mip + 1});
    }
    std::vector<Run> boxes;
    for (const Run& run : runs) {
        const auto above = std::find_if(boxes.begin(), boxes.end(), [&](const Run& box) {
            return box.layer_end == run.layer && box.mip == run.mip && box.mip_end == run.mip_end;
        });
        if (above == boxes.end())
            boxes.push_back(run);
        else
            above->layer_end = run.layer_end;
    }
    std::vector<SubresourceRange> ranges;
    for (const Run& box : boxes) {
        const uint32_t mip = mip_cuts_[box.mip], layer = layer_cuts_[box.layer];
        ranges.push_back(
            {mip, mip_cuts_[box.mip_end] - mip, layer, layer_cuts_[box.layer_end] - layer, aspects_});
    }
    return ranges;
}

}  // namespace weft
