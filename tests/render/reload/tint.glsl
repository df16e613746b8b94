const vec3 kTint = vec3(1.0, 0.75, 0.5);
