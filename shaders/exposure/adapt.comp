// Meters the histogram, adapts to the metered EV, and finds the exposure of the picture. One workgroup.
#version 460
#include "adaptation.glsl"

layout(local_size_x = 256) in;

readonly buffer Histogram { uint counts[kBins]; } histogram;
buffer Adaptation { AdaptationState state; } adaptation;

layout(push_constant) uniform Params {
    float deltaTime;  // In seconds. 0: the program gives no times, so each frame adapts at once.
    float compensation, nightDarkening;
    float meterFrom, meterTo;  // Ranks in [0, 1].
    float leastEv, mostEv;
    float brighter_s, darker_s;
} params;

// The value that the metered luminance gets before the tone curve.
const float kMiddle = 0.25;
// From kDayEv down to kNightEv, the darkening at night grows from 0 to its full value.
const float kDayEv = 10.0, kNightEv = 5.0;

shared uint counts[kBins];

uint count_all() {
    uint sum = 0u;
    for (uint i = 0u; i < kBins; ++i) sum += counts[i];
    return sum;
}

// Returns the mean of the EV of the pixels whose ranks are between meterFrom and meterTo. The rank of a pixel is the
// share of the pixels that are darker. `all` is the number of pixels. If the two ranks are equal or in the wrong order,
// returns the EV at the rank meterFrom.
float metered(float all) {
    const float from = min(params.meterFrom, 0.9999), to = max(params.meterTo, from + 1e-4);
    float sum = 0.0, weights = 0.0;
    uint below = 0u;
    for (uint i = 0u; i < kBins; ++i) {
        const float weight = metered_part(float(below) / all, float(counts[i]) / all, from, to);
        sum += weight * bin_middle_ev(i);
        weights += weight;
        below += counts[i];
    }
    return clamp(sum / weights, params.leastEv, max(params.leastEv, params.mostEv));
}

// Moves the adapted EV towards the metered EV. After the time t, their difference is multiplied by exp(−t / time_s).
// This does not depend on the number of frames in t.
float adapted(float before, float metered_ev) {
    const float time_s = metered_ev > before ? params.brighter_s : params.darker_s;
    const float rest = time_s > 0.0 ? exp(-params.deltaTime / time_s) : 0.0;
    return metered_ev + (before - metered_ev) * rest;
}

float exposure_ev(float adapted_ev) {
    const float night = clamp((kDayEv - adapted_ev) / (kDayEv - kNightEv), 0.0, 1.0);
    return log2(kMiddle / kEv0Luminance) - adapted_ev - params.nightDarkening * night + params.compensation;
}

void main() {
    const uint i = gl_LocalInvocationIndex;
    counts[i] = histogram.counts[i];
    barrier();
    const uint all = count_all();
    adaptation.state.shares[i] = all > 0u ? float(counts[i]) / float(all) : 0.0;
    if (i > 0u) return;
    // A picture without light has no EV, so the eye keeps its adaptation.
    if (all > 0u) {
        const float metered_ev = metered(float(all));
        const bool at_once = adaptation.state.adapted == 0.0 || !(params.deltaTime > 0.0);
        adaptation.state.adapted_ev = at_once ? metered_ev : adapted(adaptation.state.adapted_ev, metered_ev);
        adaptation.state.metered_ev = metered_ev;
        adaptation.state.adapted = 1.0;
    }
    adaptation.state.exposure_ev = exposure_ev(adaptation.state.adapted_ev);
}
