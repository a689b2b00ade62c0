// Shares of the light of the sun, and of sky and ground, that reach a model.
uniform vec2 lightShares;
