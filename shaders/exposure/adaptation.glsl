// The scale of the light meter, and what the buffer `adaptation` contains. EV are those of photography (film speed 100,
// meter constant 12.5): EV = log2(8 L) for a luminance of L cd/m².
#ifndef WEFT_ADAPTATION
#define WEFT_ADAPTATION

// The bins of the histogram: 256 eighths of a stop, from EV −10 to EV 22. The first and the last bin also count all
// darker and all brighter pixels.
const uint kBins = 256u;
const float kBinsPerStop = 8.0, kLeastEv = -10.0;

// Luminance that the meter shows as EV 0, in cd/m².
const float kEv0Luminance = 0.125;

struct AdaptationState {
    float exposure_ev;    // The exposure of the picture: cd/m² × 2^exposure_ev are the values for the tone curve.
    float adapted_ev;     // EV to which the eye has adapted.
    float metered_ev;     // EV of the picture of this frame.
    float adapted;        // 1 if a picture has been metered, else 0.
    float shares[kBins];  // Share of the metered pixels in each bin.
};

float bin_middle_ev(uint bin) { return kLeastEv + (float(bin) + 0.5) / kBinsPerStop; }

// Returns the part of a bin with the ranks from `below` to `below + share` that is between the ranks `from` and `to`.
float metered_part(float below, float share, float from, float to) {
    return max(min(below + share, to) - max(below, from), 0.0);
}
#endif
