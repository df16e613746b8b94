// Layout of the cube of graphs/modules/environment.json, and spherical harmonics. Mip 0 is not filtered. Mips 1 to 5
// are filtered for the roughnesses 0.1, 0.2, 0.4, 0.6 and 0.8. Light for the roughness 1 comes from the harmonics.
#ifndef WEFT_ENVIRONMENT_CUBE
#define WEFT_ENVIRONMENT_CUBE

const float kLastFiltered = 5.0;

// Returns the mip for a roughness; 6 stands for the harmonics.
float lod_of_roughness(float roughness) { return min(10.0 * roughness, 1.0 + 5.0 * roughness); }

float roughness_of_mip(int mip) { return mip < 2 ? 0.1 * float(mip) : 0.2 * float(mip - 1); }

// Returns the values of the nine basis functions (spherical harmonics) for the direction `n`.
// frame.environment_irradiance_over_pi and environmentSh contain the coefficients of these functions.
float[9] harmonic_basis(vec3 n) {
    return float[9](1.0, n.x, n.y, n.z, n.x * n.y, n.y * n.z, n.x * n.z, 3.0 * n.y * n.y - 1.0, n.x * n.x - n.z * n.z);
}

// The integrals of radiance times harmonic_basis() over the sphere, multiplied by these factors, are the coefficients
// of irradiance / π. Each factor is the square of the normalisation factor of a harmonic, times the factor of a cosine
// lobe for the order 0, 1 or 2.
const float kOrder0 = 0.25 / 3.14159265, kOrder1 = 0.5 / 3.14159265, kOrder2 = 0.9375 / 3.14159265;
const float kIrradianceFactors[9] = float[9](kOrder0, kOrder1, kOrder1, kOrder1, kOrder2, kOrder2, kOrder2,
                                             kOrder2 / 12.0, kOrder2 / 4.0);
#endif
