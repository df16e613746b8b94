// Purpose: what random frames have on demand: rings, kept resources, mip chains, ranges, depth as an input,
// layers of drawings.
#pragma once

#include "tests/graph/samples/random_graph_passes.h"

namespace weft::test {

class RandomFeatures : public RandomPasses {
 public:
    using RandomPasses::RandomPasses;

 protected:
    // One of those asked for, now and then.
    bool add_feature();
    void add_after_edges();

 private:
    // A pass that reads earlier frames and writes this one's; its seed may be a builtin.
    void remember_image();
    void remember_buffer();
    void keep_image();
    void keep_buffer();
    void mip_chain();
    void clear_range();
    void copy_range();
    void test_against_input();
    void draw_layers();
    void draw_depth_layers();
    void draw_builtin_seed(PassDecl& pass, ResourceId role);
};

}  // namespace weft::test
