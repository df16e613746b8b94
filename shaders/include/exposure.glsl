// The automatic exposure of modules/exposure.json, for shaders that make the final picture. The optional port
// `adaptation` is the resource of this name in the module.
#ifndef WEFT_EXPOSURE
#define WEFT_EXPOSURE

layout(constant_id = 22) const bool HAS_adaptation = false;
readonly buffer Adaptation { float exposure_ev; } adaptation;

// Returns the EV that the automatic exposure adds to the values in hdr, which are multiplied by pre_exposure. Returns
// 0 without the port, and in frames in which the automatic exposure is switched off. Pass the members `adaptationValid`
// and `preExposure` of Params.
float automatic_ev(float adaptation_valid, float pre_exposure) {
    if (!HAS_adaptation || adaptation_valid == 0.0) return 0.0;
    return adaptation.exposure_ev - log2(pre_exposure);
}
#endif
