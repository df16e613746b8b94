// What a surface sends to the eye of one light: the body of every loop over lights. Units: cd/m². Needs brdf.glsl and
// lights.glsl.

vec3 light_reflection(Surface s, vec3 v, vec3 position, Light light) {
    const Incident incident = light_at(light, position);
    return reflect_light(s, v, incident.direction) * incident.irradiance;
}
