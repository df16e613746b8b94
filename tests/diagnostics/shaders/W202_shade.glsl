// The shader W202_included.comp includes this file, which contains the fault.
vec4 shade(float amount) {
    return vec4(amuont);
    //          ^ W202 is expected here
}
