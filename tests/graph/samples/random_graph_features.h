// Purpose: optional features of random frames: rings, kept resources, mip chains, ranges, depth as an input,
// several draws on one image.
#pragma once

#include "tests/graph/samples/random_graph_passes.h"

namespace weft::test {

class RandomFeatures : public RandomPasses {
 public:
    using RandomPasses::RandomPasses;

 protected:
    // Sometimes adds one of the enabled features.
    bool add_feature();
    void add_after_edges();

 private:
    // A pass that reads earlier frames and writes the current one; its seed may be a builtin.
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
