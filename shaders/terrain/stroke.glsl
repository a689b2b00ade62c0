const float kStrokeShare = 0.03;  // of the distance: about 10 pixels at 640 x 360

vec3 strokeEnd(vec3 relative, vec3 normal) { return relative + normal * (kStrokeShare * length(relative)); }
