// The land's depth is all that is drawn of its mesh; terrain/land.frag gives it light.
void main() {}
