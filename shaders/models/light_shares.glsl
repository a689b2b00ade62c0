// Shares of the light that reach a model (frame.glsl).
uniform vec3 lightShares;
